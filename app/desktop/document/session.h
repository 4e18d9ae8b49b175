// The document that the window edits: the same JSON that `bole run` takes. Undo is the previous document.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>
#include <QUndoStack>
#include <memory>

#include "pipeline/document.h"

namespace bole::desktop {

// Who made an edit, and when.
struct EditNote {
  QString author;
  QDateTime time;
};

class Session : public QObject {
  Q_OBJECT

 public:
  explicit Session(QObject* parent = nullptr);

  // Throw bole::Error; the document in hand stays as it was. Every change is also written to recovery_path(), which
  // save() and discard_recovery() remove: after a crash it holds what was not saved.
  void open(const QString& path);
  void recover(const QString& path);                           // opens what a crash left of `path`; not saved yet
  void start(PipelineDocument document, const QString& path);  // a new one that is to be saved at `path`
  void save(const QString& path);                              // atomic
  static QString recovery_path(const QString& path) { return path + ".recovery"; }
  void discard_recovery();

  bool has_document() const { return document_ != nullptr; }
  const PipelineDocument& document() const { return *document_; }
  QString path() const { return path_; }

  // An edit that can be undone. Throws bole::Error when the option refuses the value.
  void set_option(const std::string& stage_id, const std::string& option, const OptionValue& value);

  // Puts a changed document in place of the one in hand, as one step of undo that the menu calls `what`.
  void change(const QString& what, PipelineDocument after);

  QUndoStack& undo_stack() { return undo_; }
  EditNote edit_note(int index) const;  // of a command of the stack

 Q_SIGNALS:
  void document_replaced();  // another document, or stages were added, taken away, renamed or joined otherwise
  void option_changed(const QString& stage, const QString& option);

 private:
  friend class EditOption;
  friend class ReplaceDocument;
  void apply(const std::string& stage_id, const std::string& option, const OptionValue& value);
  void take(PipelineDocument document, const QString& path);
  void put(const PipelineDocument& document);
  void journal() const;

  std::unique_ptr<PipelineDocument> document_;
  QString path_;
  QUndoStack undo_;
};

}  // namespace bole::desktop
