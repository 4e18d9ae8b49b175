#include "document/edit_words.h"

#include <QObject>

namespace bole::desktop {
namespace {

QString stem_action_words(stems::StemEdit::Action action) {
  using enum stems::StemEdit::Action;
  switch (action) {
    case add:
      return QObject::tr("add stem");
    case remove:
      return QObject::tr("delete stem");
    case move:
      return QObject::tr("move stem");
    case resize:
      return QObject::tr("change diameter");
    case set_height:
      return QObject::tr("change height");
    case split:
      return QObject::tr("split stem");
    case merge:
      return QObject::tr("merge stems");
    case accept:
      return QObject::tr("accept stem");
    case reject:
      return QObject::tr("reject stem");
    case note:
      return QObject::tr("note on stem");
    case set_species:
      return QObject::tr("set species");
    case tilt:
      return QObject::tr("tilt stem");
  }
  return {};
}

QString point_action_words(PointEdit::Action action) {
  using enum PointEdit::Action;
  switch (action) {
    case to_tree:
      return QObject::tr("points to a tree");
    case to_no_tree:
      return QObject::tr("points to no tree");
    case to_ground:
      return QObject::tr("points to the ground");
    case to_noise:
      return QObject::tr("points to noise");
  }
  return {};
}

QString counted(const QString& words, std::size_t count) {
  return count == 1 ? words : QString("%1 (%2)").arg(words).arg(count);
}

}  // namespace

QString edit_words(const std::vector<stems::StemEdit>& edits) {
  return edits.empty() ? QString() : counted(stem_action_words(edits.front().action), edits.size());
}

QString edit_words(const std::vector<rows::RowEdit>& edits) { return counted(QObject::tr("change row"), edits.size()); }

QString edit_words(const std::vector<plant::PlantEdit>& edits) {
  return counted(QObject::tr("change plant"), edits.size());
}

QString edit_words(const std::vector<slam::LoopEdit>& edits) {
  return counted(QObject::tr("decide loop closure"), edits.size());
}

QString edit_words(const std::vector<PointEdit>& edits) {
  return edits.empty() ? QString() : counted(point_action_words(edits.front().action), edits.size());
}

}  // namespace bole::desktop
