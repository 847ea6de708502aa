"""Types of what commands answer, for annotations and for what is made by hand."""

from ._api import *
from ._api import __all__ as __all__
