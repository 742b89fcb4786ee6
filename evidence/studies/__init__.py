"""The studies of docs/studies, computed with the released package.

They are what its pages say in numbers and pictures.

`python -m evidence.studies NAME` computes a study, and puts its tables and pictures into its page.
"""
