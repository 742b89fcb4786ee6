"""Texts for streams that have not all letters: terminals of Windows, pipes of old locales."""

from __future__ import annotations

import codecs
import re
import sys
import unicodedata
from collections.abc import Mapping

__all__ = ["PLAIN", "forgive", "printable"]

PLAIN: Mapping[str, str] = {
    **dict(zip("αγδεηθμξπρσςτφχωΔ", (
        "alpha", "gamma", "delta", "eps", "eta", "theta", "mu", "xi", "pi", "rho", "sigma", "sigma",
        "tau", "phi", "chi", "omega", "Delta",
    ), strict=True)),
    **{sign: f"^{k}" for k, sign in enumerate("⁰¹²³⁴⁵⁶⁷⁸⁹")},
    "′": "'", "″": "''", "‴": "'''", "√": "sqrt", "ℓ": "l", "∂": "d", "∞": "inf", "⁻": "^-",
    "−": "-", "–": "-", "—": "-", "─": "-", "±": "+-", "×": "x", "·": "*", "°": " deg",
    "≤": "<=", "≥": ">=", "≠": "!=", "≈": "~", "→": "->", "←": "<-", "↔": "<->", "≡": "=",
    "‘": "'", "’": "'", "“": '"', "”": '"', "ₛ": "_s", "ₖ": "_k", "ₑ": "_e",
}  # fmt: skip
"""What is written for a letter where a stream does not have it.

For others see :func:`_substitute`.
"""

_ERRORS = "littlewood"
# A cell of a table: words with one blank between them.
_CELL = re.compile(r"(\S+(?: \S+)*)")
# Most words of a cell of our tables, and the blanks that stay between two cells.
_WORDS = 2
_GAP = 2


def printable(text: str) -> str:
    """Return a text that the standard output can write, in columns as before.

    `print` encodes what `str` returns and raises an error for a letter that the stream does not
    have, and `str` does not know where its text goes. What is printed goes to the standard output,
    so that its letters decide; where it has all of them, as UTF-8 has, the text is not changed.
    """
    encoding = getattr(sys.stdout, "encoding", None)
    if not encoding:
        return text
    try:
        text.encode(encoding)
    except UnicodeEncodeError:
        return "\n".join(_in_plain(line, encoding) for line in text.split("\n"))
    return text


def forgive() -> None:
    """Let the standard streams substitute letters that they do not have, as a command does."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors=_ERRORS)


def _in_plain(line: str, encoding: str) -> str:
    """Return a line with substitutes. A longer cell takes its room from the blanks beside it."""
    parts = _CELL.split(line)
    for k in range(1, len(parts), 2):
        plain = parts[k].encode(encoding, _ERRORS).decode(encoding)
        longer = len(plain) - len(parts[k])
        parts[k] = plain
        # Only tables have columns: their cells are of one word or two. Numbers stand to the right,
        # and so the blanks before them go first.
        for beside in (k - 1, k + 1) if plain.count(" ") < _WORDS else ():
            taken = min(longer, max(0, len(parts[beside]) - _GAP))
            parts[beside] = parts[beside][taken:]
            longer -= taken
    return "".join(parts)


def _substitute(error: UnicodeError) -> tuple[str, int]:
    """Return the letters that stand for what a codec cannot encode.

    Of the table, or without their accents.
    """
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return "".join(map(_plain, error.object[error.start : error.end])), error.end


def _plain(letter: str) -> str:
    if letter in PLAIN:
        return PLAIN[letter]
    parts = unicodedata.normalize("NFKD", letter)
    bare = "".join(part for part in parts if part.isascii())
    return bare or ("" if unicodedata.combining(letter) else "?")


codecs.register_error(_ERRORS, _substitute)
