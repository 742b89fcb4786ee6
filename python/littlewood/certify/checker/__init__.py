"""The checker: follows the motion of a certificate again, by other means than the maker, and compares every number.

It uses nothing but Python's standard library, and nothing of the maker or of the rest of this package. A number passes
if its text is that of the number found here, so that no digit can be changed; a motion passes if the conditions of
docs/theory/contact.md choose it. To read it, begin with :mod:`.walk`; docs/checker.md lists the rules.

| what | where |
|---|---|
| the digest; more bits where something is not decided | :mod:`.check` |
| phases and events one after the other, and their numbers compared | :mod:`.walk` |
| which motion follows | :mod:`.decide` |
| the equations of motion, guards, states of each phase | :mod:`.body`, :mod:`.phase` |
| a phase to its end | :mod:`.follow` |
| one step, its series and its error | :mod:`.step`, :mod:`.flight` |
| zeros of guards | :mod:`.zeros` |
| impacts, and infinitely many of them | :mod:`.impact`, :mod:`.bounces` |
| intervals, series, complex discs, decimal digits | :mod:`.ranges`, :mod:`.series`, :mod:`.discs`, :mod:`.digits` |
"""

from .check import check
from .walk import Refused

__all__ = ["Refused", "check"]
