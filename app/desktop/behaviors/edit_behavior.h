// Turns what a person does to stems into edits of the document: the options of its stage stems.edit.
#pragma once

#include <QObject>
#include <vector>

#include "document/session.h"
#include "stems/core/edits/stem_edits.h"

namespace bole::desktop {

class EditBehavior : public QObject {
  Q_OBJECT

 public:
  EditBehavior(Session& session, QObject* parent) : QObject(parent), session_(session) {}

  // Adds an edit to the list, with the person's name and the time; one step of undo. Throws bole::Error when the
  // document has no stage stems.edit or the edit is none.
  void apply(const stems::StemEdit& edit) { apply(std::vector<stems::StemEdit>{edit}); }
  void apply(std::vector<stems::StemEdit> edits);  // all in one step

 Q_SIGNALS:
  void applied();

 private:
  Session& session_;
};

}  // namespace bole::desktop
