#include "running/first_look.h"

#include <QFileInfo>
#include <QLocale>
#include <algorithm>

#include "cloud/core/view_source.h"
#include "cloud/scan_frame.h"
#include "document/disk_memory.h"
#include "running/disk_view.h"

namespace bole::desktop {
namespace {

constexpr std::size_t max_shown_points = 3'000'000;  // a run needs the memory
constexpr std::size_t tried_frames = 20;             // the first ones of a capture may be damaged

QString counted(std::int64_t n) { return QLocale().toString(static_cast<qlonglong>(n)); }

QString file_of(const pipeline::StageNode& node) {
  for (const auto& spec : node.type->options->specs)
    if (spec.text_kind == TextKind::input_path)
      return QFileInfo(QString::fromStdString(std::get<std::string>(node.options.get(spec.name)))).fileName();
  return {};
}

bool gives(const pipeline::StageType& type, const char* port) { return type.output(port) != nullptr; }

std::shared_ptr<const PointCloud> thinned_to_show(const std::shared_ptr<const PointCloud>& cloud) {
  if (cloud->size() <= max_shown_points) return cloud;
  std::vector<std::uint32_t> kept;
  kept.reserve(max_shown_points);
  const double step = static_cast<double>(cloud->size()) / max_shown_points;
  for (std::size_t i = 0; i < max_shown_points; ++i)
    kept.push_back(static_cast<std::uint32_t>(step * static_cast<double>(i)));
  return std::make_shared<const PointCloud>(cloud->subset(kept));
}

void show_points(FirstSeen& seen, const std::shared_ptr<const PointCloud>& points, const Run& run) {
  if (points->empty()) return;
  seen.survey.points = points;
  seen.survey.index = std::make_shared<const PointIndex>(points, run);
}

QString words_of_size(const Eigen::Vector3d& size) {
  return FirstLook::tr("%1 × %2 × %3 m").arg(size.x(), 0, 'f', 0).arg(size.y(), 0, 'f', 0).arg(size.z(), 0, 'f', 0);
}

QString words_of_crs(const std::string& wkt) {
  return wkt.empty() ? FirstLook::tr("no coordinate system")
                     : QString::fromStdString(wkt.substr(0, wkt.find(','))).section('"', 1, 1);
}

QString extent_of(const PointCloud& cloud) {
  Eigen::Vector3f lo = cloud.positions().front(), hi = lo;
  for (const auto& p : cloud.positions()) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  return words_of_size((hi - lo).cast<double>());
}

void describe_cloud(FirstSeen& seen, const PointCloud& cloud, const Report& report) {
  seen.facts << FirstLook::tr("%1 points").arg(counted(static_cast<std::int64_t>(cloud.size())));
  if (cloud.empty()) return;
  seen.facts << extent_of(cloud);
  const auto kind = report.facts.find("kind");
  if (kind != report.facts.end() && kind->second == "single_tree") seen.facts << FirstLook::tr("a single tree");
  if (kind != report.facts.end() && kind->second == "airborne") seen.facts << FirstLook::tr("flown, no stems seen");
  const auto stems = report.counts.find("stems_in_sight");
  if (stems != report.counts.end() && stems->second > 0)
    seen.facts << FirstLook::tr("about %1 stems").arg(counted(stems->second));
  seen.facts << words_of_crs(cloud.crs_wkt);
}

void describe_scan(FirstSeen& seen, const FrameSource& source) {
  seen.facts << FirstLook::tr("%1 frames").arg(counted(static_cast<std::int64_t>(source.size())));
  if (source.size() > 1) {
    const double s = source.frame_time_s(source.size() - 1) - source.frame_time_s(0);
    seen.facts << FirstLook::tr("%1 s").arg(s, 0, 'f', s < 10 ? 1 : 0);
  }
  if (source.sensor_model() != "unknown") seen.facts << QString::fromStdString(source.sensor_model());
  if (source.pattern() == ScanPattern::lines) seen.facts << FirstLook::tr("%1 rings").arg(source.rings());
  seen.facts << (source.inertial() != nullptr ? FirstLook::tr("with inertial unit")
                                              : FirstLook::tr("no inertial unit"));
}

void show_first_frame(FirstSeen& seen, const FrameSource& source, const Run& run) {
  ScanFrame frame;
  for (std::size_t i = 0; i < std::min(source.size(), tried_frames); ++i) {
    try {
      source.read(i, frame);
    } catch (const Error& e) {
      if (e.kind() != ErrorKind::bad_input) throw;
      continue;
    }
    auto cloud = std::make_shared<PointCloud>(frame.positions);
    cloud->axes = Axes::sensor;
    if (frame.intensity.size() == frame.size()) cloud->set_column("intensity", frame.intensity);
    seen.of_sensor = true;
    return show_points(seen, cloud, run);
  }
}

FirstSeen look_from_disk(const std::filesystem::path& file, const Run& run) {
  FirstSeen seen;
  const auto disk = open_on_disk(file, disk_memory_bytes(), run);
  const auto& info = disk->tree().info();
  const auto points = counted(static_cast<std::int64_t>(info.points));
  const Eigen::Vector3d size = info.max - info.min;
  seen.facts << FirstLook::tr("%1 points").arg(points) << words_of_size(size) << FirstLook::tr("shown from the disk")
             << words_of_crs(info.crs_wkt);
  for (const auto& sentence : disk->damage()) seen.warnings << QString::fromStdString(sentence);
  const double gib = bytes_in_memory(info) / (1 << 30);
  seen.large = FirstLook::tr(
                   "The points take more than the memory for them (%1 MiB): the window shows the cloud from the "
                   "disk and loads what is seen. A run reads all %2 points, about %3 GiB. Where that is too "
                   "much, run the pipeline in tiles: bole campaign.")
                   .arg(disk_memory_mib())
                   .arg(points)
                   .arg(gib, 0, 'f', 1);
  seen.survey.points = disk->coarse();
  seen.survey.index = std::make_shared<const PointIndex>(disk);
  return seen;
}

}  // namespace

const pipeline::StageNode* input_stage(const pipeline::PipelineDocument& document) {
  for (const auto& node : document.stages())
    if (node.type->inputs.empty() && !node.skipped() &&
        (gives(*node.type, "points") || gives(*node.type, "frames") || gives(*node.type, "views")))
      return &node;
  return nullptr;
}

FirstSeen look_at_input(const pipeline::StageNode& node, const Run& run) {
  if (const auto large = cloud_for_disk(node, disk_memory_bytes())) {
    auto from_disk = look_from_disk(*large, run);
    from_disk.file = file_of(node);
    return from_disk;
  }
  FirstSeen seen;
  seen.file = file_of(node);
  Run quiet = run;
  quiet.progress = {};
  const auto result = pipeline::run_stage(*node.type, {}, node.options, quiet);
  for (const auto& warning : result.report.warnings) seen.warnings << QString::fromStdString(warning);
  const auto& outputs = result.outputs;
  if (outputs.has("points") && gives(*node.type, "points")) {
    const auto points = outputs.get<PointCloud>("points");
    describe_cloud(seen, *points, result.report);
    show_points(seen, thinned_to_show(points), run);
  } else if (outputs.has("frames")) {
    const auto source = outputs.get<FrameSource>("frames");
    describe_scan(seen, *source);
    show_first_frame(seen, *source, run);
  } else if (outputs.has("views")) {
    seen.facts << QString::fromStdString(outputs.get<ViewSource>("views")->description());
  }
  return seen;
}

void FirstLook::stop() {
  ++count_;
  for (auto& thread : threads_) thread.request_stop();
}

FirstLook::~FirstLook() { stop(); }

void FirstLook::look(const pipeline::PipelineDocument& document) {
  stop();
  const auto* node = input_stage(document);
  if (node == nullptr) return;
  threads_.emplace_back([this, copy = *node, count = count_](const std::stop_token& cancel) {
    const auto answer = [this, count](auto tell) {
      QMetaObject::invokeMethod(
          this,
          [this, count, tell = std::move(tell)] {
            if (count == count_) tell();
          },
          Qt::QueuedConnection);
    };
    try {
      Run run;
      run.cancel = cancel;
      run.progress = [&, file = file_of(copy), shown = -1.0](double fraction, std::string_view) mutable {
        if (fraction < shown + 0.01) return;
        shown = fraction;
        answer([this, file, fraction] { Q_EMIT preparing(file, fraction); });
      };
      auto seen = std::make_shared<const FirstSeen>(look_at_input(copy, run));
      answer([this, seen] { Q_EMIT this->seen(seen); });
    } catch (const std::exception& e) {
      if (!cancel.stop_requested()) answer([this, text = QString::fromUtf8(e.what())] { Q_EMIT failed(text); });
    }
  });
}

}  // namespace bole::desktop
