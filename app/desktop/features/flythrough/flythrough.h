// Makes a film of the survey that the 3-D view shows, along the walk or through the bookmarked views: the frames that
// the stage report.flythrough makes of the same inputs, with the clouds beside the survey, the map behind it and the
// terrain where they are wished.
#pragma once

#include <QDialog>
#include <memory>
#include <optional>
#include <thread>

#include "document/survey.h"
#include "render/beside/surroundings.h"
#include "report/flight/flythrough.h"
#include "views/clouds/scene_cloud.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace bole::desktop {

class SceneView;

// What the 3-D view draws about the survey.
struct FilmScenery {
  std::vector<SceneCloud> clouds;
  render::PointPaint of_survey;  // whose colours they share where they show the same numbers
  std::optional<render::PlacedPicture> map;
  std::optional<render::ShownTerrain> terrain;
};
FilmScenery scenery_of(const SceneView& scene);

class FlythroughDialog : public QDialog {
  Q_OBJECT

 public:
  // `stops`: bookmarked views.
  FlythroughDialog(const Survey& survey, std::vector<render::ViewPoint> stops, report::FlythroughOptions options,
                   QWidget* parent, FilmScenery scenery = {});
  ~FlythroughDialog() override;  // cancels

  void set_options(const report::FlythroughOptions& options);
  report::FlythroughOptions options() const;
  void start(const QString& folder);  // in the background
  void cancel();
  bool busy() const { return busy_; }
  void reject() override;  // cancels; closes when nothing is under way

 Q_SIGNALS:
  void made(const QString& said);
  void refused(const QString& why);  // also a cancelled film

 private:
  void make_form();
  void show_what_it_makes();
  render::Surroundings surroundings() const;  // those that are ticked
  QString words_of_clouds() const;            // those that the film shows, and what it lacks of them
  void end(const QString& said, const QString& why);

  Survey survey_;
  std::vector<render::ViewPoint> stops_;
  FilmScenery scenery_;
  report::FlythroughOptions options_;  // what the form does not show of them
  QComboBox *course_, *size_;
  QDoubleSpinBox* seconds_;
  QSpinBox* rate_;
  QCheckBox *stems_, *beside_, *map_, *terrain_, *video_;
  QLabel *what_, *with_clouds_;
  QProgressBar* progress_;
  QPushButton *start_, *cancel_;
  bool busy_ = false;
  std::jthread worker_;
};

}  // namespace bole::desktop
