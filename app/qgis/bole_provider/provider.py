"""The provider: an algorithm for every pipeline document of the program that reads a file."""

import pathlib

from qgis.core import QgsMessageLog, QgsProcessingProvider
from qgis.PyQt.QtGui import QIcon

from . import pipeline, program
from .algorithm import PipelineAlgorithm


class BoleProvider(QgsProcessingProvider):
    def id(self):
        return "bole"

    def name(self):
        return "Bole"

    def longName(self):
        return "Bole: LiDAR forestry"

    def icon(self):
        own = pathlib.Path(__file__).parent / "bole.svg"
        return QIcon(str(own)) if own.exists() else QIcon.fromTheme("bole")

    def loadAlgorithms(self):
        try:
            bole = program.find_program()
            stages = program.read_stages(bole)
            for name, path in program.find_documents(bole).items():
                document = pipeline.read_document(path)
                if pipeline.input_stage(document) is not None:
                    self.addAlgorithm(PipelineAlgorithm(bole, name, path, document, stages))
        except (program.ProgramError, OSError, ValueError) as error:
            QgsMessageLog.logMessage(f"Bole: {error}", "Processing")
