// Looks at the input of a document that was opened, in a thread of its own: something is seen before anything was run.
#pragma once

#include <QObject>
#include <QStringList>
#include <memory>
#include <stop_token>
#include <thread>
#include <vector>

#include "document/survey.h"
#include "pipeline/document.h"

namespace bole::desktop {

struct FirstSeen {
  QString file;            // name without folder
  QStringList facts;       // short phrases, the most telling one first: "1 204 311 points", "49 × 52 × 22 m"
  QStringList warnings;    // of the reader
  Survey survey;           // a thinned cloud, or a frame of a recording; empty of pictures
  QString large;           // what a run would have to read, where the cloud is shown from the disk
  bool of_sensor = false;  // a frame, in the axes of the sensor: what a run shows lies elsewhere
};

// The stage that reads what the document is about: the first without inputs that gives points, frames or views; null
// when there is none, or its file is not given.
const pipeline::StageNode* input_stage(const pipeline::PipelineDocument& document);

// Runs that stage and looks at what it gives; a cloud whose points take more than the memory for them is opened on the
// disk instead. Throws bole::Error.
FirstSeen look_at_input(const pipeline::StageNode& node, const Run& run);

class FirstLook : public QObject {
  Q_OBJECT

 public:
  explicit FirstLook(QObject* parent) : QObject(parent) {}
  ~FirstLook() override;  // cancels and waits

  void look(const pipeline::PipelineDocument& document);  // answers with seen() or failed(), unless there is no input
  void stop();                                            // no answer any more; cancels what is read, without waiting

 Q_SIGNALS:
  void seen(const std::shared_ptr<const bole::desktop::FirstSeen>& what);
  void failed(const QString& why);
  void preparing(const QString& file, double fraction);  // the index of a cloud that is too large for memory

 private:
  int count_ = 0;                      // answers about a document that was closed are dropped
  std::vector<std::jthread> threads_;  // of all documents; those before the last end soon
};

}  // namespace bole::desktop
