"""What classes of the package have in common."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import pandas
    import polars
    import pyarrow

    from ._table import Table


def _any(options: Mapping[str, object]) -> dict[str, Any]:
    """Options that are handed on: what takes them says which they are."""
    return dict(options)


def named(name: str) -> Any:
    """What the package has under a name: how a module makes objects of classes that are above it."""
    return getattr(sys.modules[__package__], name)


class Fixed:
    """An object that does not change."""

    __slots__ = ()

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a {type(self).__name__} does not change: {name}")


class Tabled:
    """What has a table, and gives it to data frames."""

    __slots__ = ()

    def to_table(self) -> Table:
        """The table."""
        raise NotImplementedError

    def to_pandas(self) -> pandas.DataFrame:
        """The table as a ``pandas.DataFrame``."""
        return self.to_table().to_pandas()

    def to_polars(self) -> polars.DataFrame:
        """The table as a ``polars.DataFrame``."""
        return self.to_table().to_polars()

    def to_arrow(self) -> pyarrow.Table:
        """The table as a ``pyarrow.Table``."""
        return self.to_table().to_arrow()

    def __arrow_c_stream__(self, requested_schema: object = None) -> Any:
        return self.to_table().__arrow_c_stream__(requested_schema)
