"""What QGIS loads: it registers the provider and nothing else."""

from qgis.core import QgsApplication

from .provider import BoleProvider


class BolePlugin:
    def __init__(self):
        self.provider = None

    def initProcessing(self):
        self.provider = BoleProvider()
        QgsApplication.processingRegistry().addProvider(self.provider)

    def initGui(self):
        self.initProcessing()

    def unload(self):
        if self.provider is not None:
            QgsApplication.processingRegistry().removeProvider(self.provider)
