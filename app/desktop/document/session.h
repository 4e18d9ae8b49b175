// The document that the window edits: the same JSON that `bole run` takes. Undo is the previous document.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>
#include <QUndoCommand>
#include <QUndoStack>
#include <memory>

#include "pipeline/document.h"

namespace bole::desktop {

// Who made an edit, and when.
struct EditNote {
  QString author;
  QDateTime time;
};

// A command that knows it, for the stack of the session.
class SignedCommand : public QUndoCommand {
 public:
  explicit SignedCommand(const QString& text);
  const EditNote& note() const { return note_; }

 private:
  EditNote note_;
};

class Session : public QObject {
  Q_OBJECT

 public:
  explicit Session(QObject* parent = nullptr);

  // Throw bole::Error; the document in hand stays as it was. Every change is also written to recovery_path(), which
  // save() and discard_recovery() remove: after a crash it holds what was not saved. Where that cannot be written edits
  // go on, and unprotected() says so.
  void open(const QString& path);
  void recover(const QString& path);  // opens what a crash left of `path`; not saved yet
  void start(pipeline::PipelineDocument document, const QString& path);  // a new one that is to be saved at `path`
  void save(const QString& path);                                        // atomic
  static QString recovery_path(const QString& path) { return path + ".recovery"; }
  void discard_recovery();

  bool has_document() const { return document_ != nullptr; }
  const pipeline::PipelineDocument& document() const { return *document_; }
  QString path() const { return path_; }

  // An edit that can be undone; the menu calls it `what`, else by stage and option. Throws bole::Error when the option
  // refuses the value.
  void set_option(const std::string& stage_id, const std::string& option, const OptionValue& value,
                  const QString& what = {});

  // Puts a changed document in place of the one in hand, as one step of undo that the menu calls `what`.
  void change(const QString& what, pipeline::PipelineDocument after);

  QUndoStack& undo_stack() { return undo_; }
  // Whether something would be lost: not for a document that the program made and in which every edit is undone.
  bool changed() const;
  EditNote edit_note(int index) const;           // of a command of the stack; of the last step of one that has several
  bool recovered() const { return recovered_; }  // what a crash left, not saved yet

 Q_SIGNALS:
  void document_replaced();  // another document, or stages were added, taken away, renamed or joined otherwise
  void option_changed(const QString& stage, const QString& option);
  void unprotected(const QString& why);  // changes are lost if the program ends; once until they are kept again

 private:
  friend class EditOption;
  friend class ReplaceDocument;
  void apply(const std::string& stage_id, const std::string& option, const OptionValue& value, bool given);
  void take(pipeline::PipelineDocument document, const QString& path);
  void put(const pipeline::PipelineDocument& document);
  void journal();

  std::unique_ptr<pipeline::PipelineDocument> document_;
  QString path_;
  QUndoStack undo_;
  bool recovered_ = false;
  bool made_ = false;      // by the program, and never saved
  bool protected_ = true;  // the last change could be written to recovery_path()
};

}  // namespace bole::desktop
