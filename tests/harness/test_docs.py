"""The files that the documentation shows are those that the tests compile and run."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SHOWN_FILE = re.compile(r"^`(docs/[\w/.]+)`\n\n```\w+\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def test_variants_shows_every_file_of_its_folder_as_it_is():
    shown = dict(SHOWN_FILE.findall((ROOT / "docs" / "variants.md").read_text()))
    files = {f"docs/variants/{file.name}": file.read_text() for file in (ROOT / "docs/variants").iterdir()}
    assert shown == files
