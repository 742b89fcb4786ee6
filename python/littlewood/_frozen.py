"""Mappings that do not change."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, TypeVar

__all__ = ["Frozen"]

_K = TypeVar("_K")
_V = TypeVar("_V", covariant=True)


class Frozen(Mapping[_K, _V]):
    """A mapping that does not change, and that can be pickled, which a MappingProxyType cannot."""

    _items: dict[Any, Any]

    def __init__(self, items: Mapping[_K, _V] | Iterable[tuple[_K, _V]]) -> None:
        object.__setattr__(self, "_items", dict(items))

    def __getitem__(self, key: _K) -> _V:
        value: _V = self._items[key]
        return value

    def __iter__(self) -> Iterator[_K]:
        return iter(self._items)

    def __len__(self) -> int:
        return len(self._items)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("this mapping does not change")

    def __reduce__(self) -> tuple[Any, ...]:
        return Frozen, (self._items,)

    def __repr__(self) -> str:
        return repr(self._items)
