#include "document/session.h"

#include <QFile>
#include <exception>
#include <utility>

#include "base/atomic_file.h"
#include "document/person.h"
#include "document/unsaved.h"

namespace bole::desktop {

SignedCommand::SignedCommand(const QString& text) : QUndoCommand(text), note_{person(), QDateTime::currentDateTime()} {}

class EditOption : public SignedCommand {
 public:
  EditOption(Session& session, std::string stage, std::string option, OptionValue before, OptionValue after,
             bool given_before, const QString& what)
      : SignedCommand(what.isEmpty()
                          ? QObject::tr("%1: %2").arg(QString::fromStdString(stage), QString::fromStdString(option))
                          : what),
        session_(session),
        stage_(std::move(stage)),
        option_(std::move(option)),
        before_(std::move(before)),
        after_(std::move(after)),
        given_before_(given_before) {}

  void undo() override { session_.apply(stage_, option_, before_, given_before_); }
  void redo() override { session_.apply(stage_, option_, after_, true); }

 private:
  Session& session_;
  std::string stage_, option_;
  OptionValue before_, after_;
  bool given_before_;
};

class ReplaceDocument : public SignedCommand {
 public:
  ReplaceDocument(Session& session, const QString& what, pipeline::PipelineDocument before,
                  pipeline::PipelineDocument after)
      : SignedCommand(what), session_(session), before_(std::move(before)), after_(std::move(after)) {}

  void undo() override { session_.put(before_); }
  void redo() override { session_.put(after_); }

 private:
  Session& session_;
  pipeline::PipelineDocument before_, after_;
};

Session::Session(QObject* parent) : QObject(parent) {
  // What was undone as far as it was saved needs no recovery. Another document empties the stack: that is no undoing.
  connect(&undo_, &QUndoStack::cleanChanged, this, [this](bool clean) {
    if (clean && undo_.count() > 0) discard_recovery();
  });
  connect(&undo_, &QUndoStack::indexChanged, this, [this](int index) {
    if (index == 0 && undo_.count() > 0 && !changed()) discard_recovery();
  });
}

void Session::open(const QString& path) {
  take(pipeline::PipelineDocument::load(path.toStdString(), pipeline::StageRegistry::global()), path);
}

void Session::recover(const QString& path) {
  // Beside the document, so that relative paths hold.
  take(pipeline::PipelineDocument::load(recovery_path(path).toStdString(), pipeline::StageRegistry::global()), path);
  undo_.resetClean();
  recovered_ = true;
}

void Session::start(pipeline::PipelineDocument document, const QString& path) {
  take(std::move(document), path);
  undo_.resetClean();
  made_ = true;
}

bool Session::changed() const {
  if (!has_document() || undo_.isClean()) return false;
  return !made_ || undo_.index() > 0;
}

void Session::change(const QString& what, pipeline::PipelineDocument after) {
  undo_.push(new ReplaceDocument(*this, what, *document_, std::move(after)));
}

void Session::put(const pipeline::PipelineDocument& document) {
  document_ = std::make_unique<pipeline::PipelineDocument>(document);
  journal();
  Q_EMIT document_replaced();
}

void Session::take(pipeline::PipelineDocument document, const QString& path) {
  document_ = std::make_unique<pipeline::PipelineDocument>(std::move(document));
  path_ = path;
  undo_.clear();
  undo_.setClean();  // Qt leaves an empty stack as it was: after start() that is not clean
  recovered_ = false;
  made_ = false;
  protected_ = true;
  Q_EMIT document_replaced();
}

void Session::discard_recovery() {
  if (path_.isEmpty()) return;
  QFile::remove(recovery_path(path_));
  forget_unsaved(path_);
}

// Called by commands of the stack, through which nothing may be thrown: Qt calls them from its own loop.
void Session::journal() {
  if (path_.isEmpty()) return;
  try {
    write_text_file(recovery_path(path_).toStdString(), document_->to_json());
    note_unsaved(path_);
    protected_ = true;
  } catch (const std::exception& e) {
    if (std::exchange(protected_, false)) Q_EMIT unprotected(QString::fromUtf8(e.what()));
  }
}

EditNote Session::edit_note(int index) const {
  const auto* command = undo_.command(index);
  while (command && command->childCount() > 0) command = command->child(command->childCount() - 1);
  const auto* edit = dynamic_cast<const SignedCommand*>(command);
  return edit ? edit->note() : EditNote{};
}

void Session::save(const QString& path) {
  write_text_file(path.toStdString(), document_->to_json());
  discard_recovery();
  path_ = path;
  recovered_ = false;
  made_ = false;
  undo_.setClean();
}

void Session::set_option(const std::string& stage_id, const std::string& option, const OptionValue& value,
                         const QString& what) {
  const auto& node = document_->at(stage_id);
  const OptionValue checked = node.type->options->at(option).checked(value);
  const OptionValue before = node.options.get(option);
  if (checked == before) return;
  undo_.push(new EditOption(*this, stage_id, option, before, checked, node.given.contains(option),
                            what));  // the stack owns it and calls redo()
}

void Session::apply(const std::string& stage_id, const std::string& option, const OptionValue& value, bool given) {
  for (auto& node : document_->stages())
    if (node.id == stage_id) {
      node.options.set(option, value);
      if (given)
        node.given.insert(option);
      else
        node.given.erase(option);
    }
  journal();
  Q_EMIT option_changed(QString::fromStdString(stage_id), QString::fromStdString(option));
}

}  // namespace bole::desktop
