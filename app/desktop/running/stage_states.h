// How the stages of the document fared: in the run that is under way, else in the last one that came to them. A change
// of what a stage depends on makes its result out of date; an undo makes it good again.
#pragma once

#include <QByteArray>
#include <QObject>
#include <QStringList>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "look/stage_icons.h"

namespace bole::vtkbridge {
struct StageOutcome;
}

namespace bole::desktop {

class Runner;
class Session;

struct StageState {
  enum class Kind { not_run, running, done, warnings, failed, out_of_date, cannot_run, skipped };
  Kind kind = Kind::not_run;
  double fraction = 0;            // of a stage that runs
  std::optional<double> seconds;  // that it took when its result was made
  QString message;                // what it said, why it failed or cannot run
  QStringList warnings;
};

StageMark mark_of(StageState::Kind kind);
QString state_words(const StageState& state);    // "2 warnings"; empty of a stage that was not run
QString seconds_words(double seconds);           // "0.3 s", "12 s", "2:05 min"
QString state_details(const StageState& state);  // message, warnings and seconds, for a tooltip

class StageStates : public QObject {
  Q_OBJECT

 public:
  StageStates(const Session& session, const Runner& runner, QObject* parent);

  StageState of(const std::string& id) const;
  void forget();  // runs of another document

 Q_SIGNALS:
  void changed();                         // of any stage
  void stage_changed(const QString& id);  // one stage began, went on or ended

 private:
  struct Last {
    QByteArray key;  // of all that the result depends on
    StageState state;
  };
  void look_at_document();
  void progress(const QString& stage, double fraction, const QString& what);
  void take(int job);
  void take(const vtkbridge::StageOutcome& stage, const QByteArray& key);
  const Last* last(const std::string& id) const;  // null: none

  const Session& session_;
  const Runner& runner_;
  std::map<std::string, Last> last_;        // by id
  std::map<std::string, QByteArray> keys_;  // of the document as it stands
  std::map<std::string, std::string> problems_;
  int job_ = 0;  // that is under way
  std::string running_;
  std::set<std::string> passed_;  // stages of that job which are done
  double fraction_ = 0;
  QString what_;
  int ignored_ = 0;  // jobs up to this one were of another document
};

}  // namespace bole::desktop
