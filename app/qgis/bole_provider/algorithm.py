"""A pipeline document as an algorithm of Processing."""

import pathlib

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingOutputFile,
    QgsProcessingOutputHtml,
    QgsProcessingOutputMultipleLayers,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFile,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterString,
    QgsProviderRegistry,
)

from . import pipeline, program

FOLDER = "OUTPUT_FOLDER"


def number(p):
    kind = QgsProcessingParameterNumber.Integer if p.kind == "integer" else QgsProcessingParameterNumber.Double
    made = QgsProcessingParameterNumber(p.name, p.label, kind, p.default, p.optional)
    if p.low is not None:
        made.setMinimum(p.low)
    if p.high is not None:
        made.setMaximum(p.high)
    return made


MAKERS = {
    "file": lambda p: QgsProcessingParameterFile(p.name, p.label, defaultValue=p.default or None, optional=p.optional),
    "boolean": lambda p: QgsProcessingParameterBoolean(p.name, p.label, p.default, p.optional),
    "integer": number,
    "number": number,
    "choice": lambda p: QgsProcessingParameterEnum(p.name, p.label, p.choices, False, p.default, p.optional, True),
    "text": lambda p: QgsProcessingParameterString(p.name, p.label, p.default or None, False, p.optional),
}


def layers_of(folder):
    """What a map can show of a survey: (URI, name) of the layers of plot.gpkg and of the rasters."""
    found = []
    for package in sorted(folder.glob("*.gpkg")):
        for layer in QgsProviderRegistry.instance().querySublayers(str(package)):
            found.append((layer.uri(), layer.name()))
    return found + [(str(p), p.stem) for p in sorted(folder.glob("*.tif"))]


class PipelineAlgorithm(QgsProcessingAlgorithm):
    def __init__(self, bole, name, path, document, stages):
        super().__init__()
        self.given = (bole, name, path, document, stages)
        self.bole, self.document_name, self.path, self.document, _ = self.given
        self.form = pipeline.parameters(document, stages)

    def createInstance(self):
        return PipelineAlgorithm(*self.given)

    def name(self):
        return self.document_name

    def displayName(self):
        return self.document["title"]

    def shortHelpString(self):
        return self.document.get("description", "") + "\n\n" + "\n".join(f"{p.label}: {p.help}" for p in self.form if not p.advanced)

    def initAlgorithm(self, _configuration=None):
        for p in self.form:
            made = MAKERS[p.kind](p)
            made.setHelp(p.help)
            if p.advanced:
                made.setFlags(made.flags() | QgsProcessingParameterDefinition.FlagAdvanced)
            self.addParameter(made)
        self.addParameter(QgsProcessingParameterFolderDestination(FOLDER, "Folder for the results"))
        self.addOutput(QgsProcessingOutputMultipleLayers("LAYERS", "Layers: stems, terrain, ..."))
        self.addOutput(QgsProcessingOutputHtml("REPORT", "Report"))
        self.addOutput(QgsProcessingOutputFile("SUMMARY", "All numbers (summary.json)"))

    def value_of(self, p, parameters, context):
        if p.name not in parameters or parameters[p.name] is None:
            return None
        read = {
            "file": self.parameterAsFile,
            "boolean": self.parameterAsBoolean,
            "integer": self.parameterAsInt,
            "number": self.parameterAsDouble,
            "choice": self.parameterAsEnumString,
            "text": self.parameterAsString,
        }[p.kind]
        return read(parameters, p.name, context)

    def processAlgorithm(self, parameters, context, feedback):
        folder = pathlib.Path(self.parameterAsString(parameters, FOLDER, context))
        values = {p.name: self.value_of(p, parameters, context) for p in self.form}
        arguments = pipeline.command(self.bole, self.path, self.form, values, folder)
        feedback.pushCommandInfo(" ".join(map(str, arguments)))
        try:
            finished = program.run(arguments, pipeline.stage_ids(self.document), feedback.setProgress, feedback.pushConsoleInfo, feedback.isCanceled)
        except program.ProgramError as error:
            raise QgsProcessingException(str(error)) from error
        if not finished:
            return {}
        self.tell_findings(folder, feedback)
        return self.results(folder, context)

    def tell_findings(self, folder, feedback):
        verdict, found = program.findings(folder)
        if verdict in ("look", "refused"):
            feedback.pushWarning(f"Verdict: {verdict}. Read the report before the results are used.")
        for finding in found:
            tell = feedback.pushInfo if finding.get("severity") == "note" else feedback.pushWarning
            tell(f"{finding.get('severity')}: {finding.get('text')}")

    def results(self, folder, context):
        layers = layers_of(folder)
        for uri, name in layers:
            details = QgsProcessingContext.LayerDetails(name, context.project(), "LAYERS")
            context.addLayerToLoadOnCompletion(uri, details)
        made = {FOLDER: str(folder), "LAYERS": [uri for uri, _ in layers]}
        for key, file in (("REPORT", "report.html"), ("SUMMARY", "summary.json")):
            if (folder / file).is_file():
                made[key] = str(folder / file)
        return made
