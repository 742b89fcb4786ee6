from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient

NOTEBOOK = Path(__file__).parents[1] / "notebooks" / "paper.ipynb"


@pytest.mark.thorough
@pytest.mark.filterwarnings("default")
def test_the_notebook_runs_from_first_cell_to_last(tmp_path):
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    # Its cells assert what the text says; any that fails raises here.
    NotebookClient(notebook, timeout=120, resources={"metadata": {"path": tmp_path}}).execute()
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert all(cell.execution_count for cell in code)
    pictures = [o for cell in code for o in cell.outputs if "image/png" in o.get("data", {})]
    assert len(pictures) >= 14
    # It is kept without outputs.
    assert not any(cell.get("outputs") for cell in nbformat.read(NOTEBOOK, as_version=4).cells)
