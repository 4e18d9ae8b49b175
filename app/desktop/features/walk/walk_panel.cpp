#include "features/walk/walk_panel.h"

#include <QVBoxLayout>
#include <algorithm>

#include "features/walk/frame_bar.h"

namespace bole::desktop {
namespace {

constexpr std::chrono::seconds pace_over{5};

const pipeline::StageNode* scan_stage(const pipeline::PipelineDocument& document) {
  for (const auto& node : document.stages())
    if (node.type->inputs.empty() && node.type->output("frames") && !node.skipped()) return &node;
  return nullptr;
}

// The first table of this name that a stage gave.
const Table* table_named(const Results& results, const char* port) {
  for (const auto& [id, data] : results)
    if (data.has(port) && data_kind(data.all().find(port)->second) == DataKind::table) return &data.table(port);
  return nullptr;
}

}  // namespace

WalkPanel::WalkPanel(Session& session, Runner& runs, QWidget* parent)
    : QWidget(parent),
      session_(session),
      runs_(runs),
      view_(new WalkView(this)),
      bar_(new FrameBar(this)),
      reader_(new FrameReader(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(view_, 1);
  layout->addWidget(bar_);
  connect(&session_, &Session::document_replaced, this, [this] {
    if (session_.path() != document_) {  // another one, not a step of undo
      document_ = session_.path();
      walk_.reset();
      live_ = {};
      is_live_ = false;
      scan_.clear();
      bar_->set_frames({});
      reader_->open(nullptr);
      view_->clear();
    }
    open_scan();
  });
  connect(&session_, &Session::option_changed, this, &WalkPanel::open_scan);
  connect(reader_, &FrameReader::opened, this, [this](const std::vector<double>& times_s) {
    first_s_ = times_s.empty() ? 0 : times_s.front();
    bar_->set_frames(times_s);
    if (!times_s.empty() && !is_live_) ask(0);
  });
  connect(reader_, &FrameReader::failed, this, &WalkPanel::failed);
  connect(reader_, &FrameReader::frame_read, this, &WalkPanel::show_frame);
  connect(bar_, &FrameBar::frame_asked, this, [this](int frame) {
    following_ = false;
    ask(frame);
  });
  connect(&runs_, &Runner::snapshot_taken, this, [this](const QString& stage, const DataSet& part) { take(stage, part); });
  connect(&runs_, &Runner::jobs_changed, this, [this] {
    if (is_live_ && following_) bar_->set_text(live_text());
  });
  connect(&runs_, &Runner::finished, this,
          [this](const vtkbridge::RunOutcome&, const Results& results) { show_result(results); });
  connect(&runs_, &Runner::job_began, this, [this] {
    live_ = {};
    pace_.clear();
    following_ = true;
  });
}

void WalkPanel::open_scan() {
  const auto* node = scan_stage(session_.document());
  std::string scan;  // with every option: another cut of the frames is another scan
  if (node)
    for (const auto& spec : node->type->options->specs) scan += option_text(node->options.get(spec.name)) + "\n";
  if (scan == scan_) return;
  scan_ = scan;
  bar_->set_frames({});
  reader_->open(node);
}

void WalkPanel::take(const QString& stage, const DataSet& part) {
  if (!part.has("keyframes") && !part.has("loops") && !part.has("trajectory")) return;  // of another kind of stage
  if (!is_live_) {
    is_live_ = true;
    view_->clear();
    Q_EMIT live_began();
  }
  live_stage_ = stage;
  live_.add(part);
  if (live_.state()) {
    const auto now = Job::Clock::now();
    pace_.emplace_back(now, live_.state()->frame);
    while (now - pace_.front().first > pace_over) pace_.pop_front();
    if (following_) bar_->follow(static_cast<int>(live_.state()->frame));
  }
  view_->show_live(live_, following_);
  std::vector<double> times_s;
  for (const auto& k : live_.keyframes()) times_s.push_back(k.time_s);
  bar_->set_keyframes(times_s);
  if (following_) bar_->set_text(live_text());
}

double WalkPanel::frames_per_s() const {
  if (pace_.size() < 2) return 0;
  const double s = std::chrono::duration<double>(pace_.back().first - pace_.front().first).count();
  return s > 0 ? static_cast<double>(pace_.back().second - pace_.front().second) / s : 0;
}

// Frames are left to it: it was not told to end with what it has, and no other stage runs.
bool WalkPanel::live_stage_goes_on() const {
  const auto job = runs_.current();
  return job && job->stage == live_stage_ && !job->ending;
}

QString WalkPanel::live_text() const {
  if (!live_.state()) return {};
  const auto& s = *live_.state();
  QString text = tr("frame %1 of %2").arg(s.frame + 1).arg(s.frames);
  if (const double pace = frames_per_s(); pace > 0 && live_stage_goes_on())
    text += tr("   %1 frames/s   %2 left")
                .arg(pace, 0, 'f', pace < 10 ? 1 : 0)
                .arg(duration_text(static_cast<double>(s.frames - 1 - s.frame) / pace));
  if (!live_.loops().empty()) {
    const auto good = std::ranges::count(live_.loops(), true, &LiveMap::Loop::accepted);
    text += "   " + tr("%n loop(s), %1 refused", nullptr, static_cast<int>(good))
                        .arg(static_cast<long long>(live_.loops().size()) - good);
  }
  if (!s.ok) text += tr("   not placed");
  return text;
}

// A run that ended without a map (cancelled, failed) leaves what it had shown.
void WalkPanel::show_result(const Results& results) {
  const bool was_live = std::exchange(is_live_, false);
  const Survey& survey = runs_.survey();
  if (survey.walk && survey.walk != walk_) {
    walk_ = survey.walk;
    view_->show_survey(survey, table_named(results, "loops"));
    if (const auto* odometry = table_named(results, "odometry"); odometry && odometry->has("keyframe")) {
      // The first frame of each key frame's stretch.
      const auto keyframe = odometry->integers("keyframe");
      const auto time_s = odometry->numbers("time_s");
      std::vector<double> times_s;
      for (std::size_t i = 0; i < keyframe.size(); ++i)
        if (i == 0 || keyframe[i] != keyframe[i - 1]) times_s.push_back(time_s[i]);
      bar_->set_keyframes(times_s);
    }
    if (bar_->frames() > 0) ask(bar_->frame());
  }
  if (was_live && following_ && live_.state()) bar_->set_text(live_text());  // until the frame is read
  if (was_live) Q_EMIT live_ended();
}

// While a run is under way the path so far, else that of the last result.
std::shared_ptr<const Trajectory> WalkPanel::path() const { return is_live_ ? live_.path() : walk_; }

void WalkPanel::ask(int frame) { reader_->ask(static_cast<std::size_t>(std::max(0, frame)), path()); }

void WalkPanel::show_frame(const PlacedFrame& frame) {
  if (is_live_ && following_) return;
  // Without a path a frame lies about the sensor; among the points of a map that would mislead.
  const bool shown = frame.placed || !path();
  if (shown) view_->show_frame(frame);
  const Eigen::Vector3d at = frame.T_target_sensor.translation();
  QString text = tr("frame %1 of %2   %3 s   %4 points")
                     .arg(frame.index + 1)
                     .arg(bar_->frames())
                     .arg(frame.time_s - first_s_, 0, 'f', 2)
                     .arg(frame.positions.size());
  if (frame.placed)
    text += tr("   at %1, %2, %3 m").arg(at.x(), 0, 'f', 2).arg(at.y(), 0, 'f', 2).arg(at.z(), 0, 'f', 2);
  else
    text += path() ? tr("   not on the path") : tr("   sensor axes");
  bar_->set_text(text);
}

}  // namespace bole::desktop
