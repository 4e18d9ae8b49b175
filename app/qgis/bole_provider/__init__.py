"""Bole in QGIS Processing."""


def classFactory(iface):  # noqa: N802, the name is QGIS's
    from .plugin import BolePlugin

    return BolePlugin()
