// What the graph of a pipeline shows, read from its document: stages, and what they take from each other.
#pragma once

#include <QCoreApplication>
#include <QStringList>
#include <string>
#include <vector>

#include "document/survey.h"
#include "pipeline/document.h"

namespace bole::desktop {

struct StageGraph {
  Q_DECLARE_TR_FUNCTIONS(bole::desktop::StageGraph)

 public:
  struct Joint {
    std::string output, input;  // ports
  };
  struct Join {  // all that one stage takes from another
    std::size_t from = 0, to = 0;
    std::vector<Joint> joints;
  };
  struct Stage {
    QString id, title, description;
    std::vector<const pipeline::Port*> outputs;
    QStringList missing;  // required inputs that are joined to nothing
  };

  static StageGraph of(const pipeline::PipelineDocument& document);

  // The stages, and a line for each joint: ports, kind of data and number of arrays, of the result where there is one.
  QString words(const Join& join, const Results& results) const;

  std::vector<Stage> stages;
  std::vector<Join> joins;
};

}  // namespace bole::desktop
