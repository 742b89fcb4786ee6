"""Certificates of motions: every number a ball, every event proved, and none missed.

:func:`certify` follows a motion with arithmetic that encloses rounding and truncation (Arb, by
python-flint: the extra `certify`); :func:`check` follows it again by other means, without any
package, and refuses a certificate of which a digit has been changed. :class:`Proof` keeps what the
checker has enclosed, and draws it. ``python -m littlewood.certify`` does all of it from the command
line.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .case import Case, CaseError
from .checker import Refused, check
from .proof import NoCertificate, Proof

if TYPE_CHECKING:
    from .certificate import certify, dump

__all__ = ["Case", "CaseError", "NoCertificate", "Proof", "Refused", "certify", "check", "dump"]


def __getattr__(name: str) -> Any:
    # The maker needs python-flint; the checker does not.
    if name in ("certify", "dump"):
        from . import certificate

        return getattr(certificate, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
