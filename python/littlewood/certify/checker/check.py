"""The check of a certificate: its digest, and the motion followed again with as many bits as it takes."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from typing import Any

from .ranges import Inconclusive, Range
from .walk import Refused, Walk


def check(certificate: Mapping[str, Any], bits: tuple[int, ...] = (192, 320, 512, 1024, 2048)) -> dict[str, int]:
    """Check a certificate.

    Parameters
    ----------
    certificate : mapping
        What a file of a certificate says.
    bits : tuple of int, optional
        Precisions that are tried, one after the other.

    Returns
    -------
    dict
        How many numbers, phases and events were found again.

    Raises
    ------
    Refused
        With the first number that is not right.
    """
    rest = {key: value for key, value in certificate.items() if key != "digest"}
    found = hashlib.sha256(json.dumps(rest, sort_keys=True, separators=(",", ":")).encode()).hexdigest()
    if found != certificate.get("digest"):
        raise Refused("the digest is not that of the certificate")
    if (certificate.get("format"), certificate.get("version")) != ("littlewood-certificate", 1):
        raise Refused("this is no certificate of a known version")
    if certificate.get("certified") is not True:
        raise Refused(f"nothing is certified: {certificate.get('reason')}")
    reason = ""
    for number in bits:
        Range.bits = number
        try:
            return Walk(certificate).follow()
        except (Inconclusive, OverflowError) as inconclusive:
            reason = f"{inconclusive} with {number} bits"
        except (KeyError, TypeError, IndexError, ValueError, AttributeError) as error:
            raise Refused(f"the certificate is not complete: {error!r}") from error
    raise Refused(f"the check is inconclusive: {reason}")
