"""The studies of docs/studies: what their pages say in numbers and pictures, computed with the released package.

`python -m evidence.studies NAME` computes a study, and puts its tables and pictures into its page.
"""
