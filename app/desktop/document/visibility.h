// Which stages each view shows. A view shows the last output of each kind that is not hidden: hide the edits and the
// stems as measured are seen.
#pragma once

#include <QObject>
#include <array>
#include <map>
#include <set>

#include "document/survey.h"

namespace bole::desktop {

enum class ViewKind { scene, cuts };  // the 3-D view; slice and profile

class Visibility : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  bool shown(const std::string& stage, ViewKind view) const { return !hidden(view).contains(stage); }
  void show(const std::string& stage, ViewKind view, bool on);
  void show_all();

  void take(const vtkbridge::RunOutcome& outcome, const Results& results);  // of the last run
  // For the thread of the window: what comes into sight gets its levels of detail in the background, once.
  Survey survey_for(ViewKind view, const Survey& all) const;

 Q_SIGNALS:
  void changed();

 private:
  const std::set<std::string>& hidden(ViewKind view) const { return hidden_[static_cast<std::size_t>(view)]; }

  std::shared_ptr<const PointIndex> index_of(const std::shared_ptr<const PointCloud>& points, const Survey& all) const;

  std::array<std::set<std::string>, 2> hidden_;
  vtkbridge::RunOutcome outcome_;
  Results results_;
  mutable std::map<std::shared_ptr<const PointCloud>, std::shared_ptr<const PointIndex>> indices_;
};

}  // namespace bole::desktop
