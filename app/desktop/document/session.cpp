#include "document/session.h"

#include <QSaveFile>
#include <QUndoCommand>

namespace bole::desktop {

class EditOption : public QUndoCommand {
 public:
  EditOption(Session& session, std::string stage, std::string option, OptionValue before, OptionValue after)
      : QUndoCommand(QObject::tr("%1: %2").arg(QString::fromStdString(stage), QString::fromStdString(option))),
        session_(session),
        stage_(std::move(stage)),
        option_(std::move(option)),
        before_(std::move(before)),
        after_(std::move(after)) {}

  void undo() override { session_.apply(stage_, option_, before_); }
  void redo() override { session_.apply(stage_, option_, after_); }

 private:
  Session& session_;
  std::string stage_, option_;
  OptionValue before_, after_;
};

Session::Session(QObject* parent) : QObject(parent) {}

void Session::open(const QString& path) {
  auto document =
      std::make_unique<PipelineDocument>(PipelineDocument::load(path.toStdString(), StageRegistry::global()));
  document_ = std::move(document);
  path_ = path;
  undo_.clear();
  Q_EMIT document_replaced();
}

void Session::save(const QString& path) {
  QSaveFile file(path);
  const QByteArray text = QByteArray::fromStdString(document_->to_json());
  if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit())
    throw failure("cannot write '" + path.toStdString() + "': " + file.errorString().toStdString(),
                  "a folder that can be written to");
  path_ = path;
  undo_.setClean();
}

void Session::set_option(const std::string& stage_id, const std::string& option, const OptionValue& value) {
  const auto& node = document_->at(stage_id);
  const OptionValue checked = node.type->options->at(option).checked(value);
  const OptionValue before = node.options.get(option);
  if (checked == before) return;
  undo_.push(new EditOption(*this, stage_id, option, before, checked));  // the stack owns it and calls redo()
}

void Session::apply(const std::string& stage_id, const std::string& option, const OptionValue& value) {
  for (auto& node : document_->stages())
    if (node.id == stage_id) {
      node.options.set(option, value);
      node.given.insert(option);
    }
  Q_EMIT option_changed(QString::fromStdString(stage_id), QString::fromStdString(option));
}

}  // namespace bole::desktop
