"""The version, that of fixed/version.hpp; the test `packaging.versions` compares them."""

__version__ = "1.0.0"
