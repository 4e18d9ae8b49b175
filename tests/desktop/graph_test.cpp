// The graph of the pipeline: where boxes and arrows are put, what they say, selection, states after a run, pictures.
#include <QDockWidget>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QRegularExpression>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <QXmlStreamReader>
#include <fstream>
#include <random>
#include <set>

#include "document/edit_list.h"
#include "features/graph/graph_view.h"
#include "look/language.h"
#include "look/theme.h"
#include "panels/pipeline_panel.h"
#include "panels/properties_panel.h"
#include "running/stage_states.h"
#include "sample_window.h"
#include "shell/modes.h"
#include "small_plot.h"

namespace bole::desktop {
namespace {

constexpr QSizeF box_size(100, 40);
constexpr GraphSpacing spacing{30, 12, 8};

// Arrows from lower to higher numbers, which need not be the order of the layers.
std::vector<GraphArrow> random_arrows(std::size_t boxes, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (int k = 0; k < count; ++k) {
    const std::size_t a = random() % boxes, b = random() % boxes;
    if (a != b) pairs.insert(std::minmax(a, b));
  }
  std::vector<GraphArrow> arrows;
  for (const auto& [from, to] : pairs) arrows.push_back({from, to});
  return arrows;
}

// What is wrong with a layout; empty: nothing.
QString fault_of(const GraphLayout& layout, const std::vector<GraphArrow>& arrows, Qt::Orientation orientation) {
  const auto along = [&](const QPointF& p) { return orientation == Qt::Horizontal ? p.x() : p.y(); };
  for (std::size_t a = 0; a < layout.boxes.size(); ++a)
    for (std::size_t b = a + 1; b < layout.boxes.size(); ++b)
      if (layout.boxes[a].intersects(layout.boxes[b])) return QString("boxes %1 and %2 overlap").arg(a).arg(b);
  for (std::size_t a = 0; a < arrows.size(); ++a) {
    const auto& way = layout.arrows[a];
    const auto name = QString("arrow %1 ").arg(a);
    if (layout.layers[arrows[a].from] >= layout.layers[arrows[a].to]) return name + "points back";
    for (std::size_t i = 1; i < way.size(); ++i) {
      if (along(way[i]) <= along(way[i - 1])) return name + "turns back";
      const QRectF straight = QRectF(way[i - 1], way[i]).normalized().adjusted(-0.1, -0.1, 0.1, 0.1);
      for (std::size_t b = 0; b < layout.boxes.size() && i % 2 == 0; ++b)
        if (straight.intersects(layout.boxes[b])) return name + QString("runs through box %1").arg(b);
    }
    for (const auto& p : way)
      if (!layout.extent.adjusted(-1, -1, 1, 1).contains(p)) return name + "leaves the picture";
  }
  return {};
}

// Of straight arrows between two layers.
int crossings(const GraphLayout& layout, const std::vector<GraphArrow>& arrows) {
  int count = 0;
  for (const auto& a : arrows)
    for (const auto& b : arrows) {
      const double begin = layout.boxes[a.from].top() - layout.boxes[b.from].top();
      const double end = layout.boxes[a.to].top() - layout.boxes[b.to].top();
      count += begin < 0 && end > 0;
    }
  return count;
}

double difference(const QImage& a, const QImage& b) {
  double sum = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) sum += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
  return sum / 255 / a.width() / a.height();
}

// As a program that shows SVG draws the paths of such a file.
QImage drawn_svg(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return {};
  QXmlStreamReader xml(&file);
  QImage image;
  QPainter painter;
  static const QRegularExpression step("([MLC])([^MLC]*)");
  while (!xml.atEnd()) {
    xml.readNext();
    if (!xml.isStartElement()) continue;
    const auto value = [&](const char* name) { return xml.attributes().value(name).toString(); };
    if (xml.name() == QLatin1String("svg")) {
      image = QImage(value("width").toInt(), value("height").toInt(), QImage::Format_RGB32);
      image.fill(Qt::black);  // all of the paper is drawn
      painter.begin(&image);
      painter.setRenderHint(QPainter::Antialiasing);
      continue;
    }
    QPainterPath shape;
    shape.setFillRule(value("fill-rule") == "evenodd" ? Qt::OddEvenFill : Qt::WindingFill);
    for (auto it = step.globalMatch(value("d")); it.hasNext();) {
      const auto match = it.next();
      const auto n = match.captured(2).split(' ');
      const auto point = [&](int i) { return QPointF(n[2 * i].toDouble(), n[2 * i + 1].toDouble()); };
      if (match.captured(1) == "M") shape.moveTo(point(0));
      if (match.captured(1) == "L") shape.lineTo(point(0));
      if (match.captured(1) == "C") shape.cubicTo(point(0), point(1), point(2));
    }
    painter.setBrush(value("fill") == "none" ? QBrush(Qt::NoBrush) : QBrush(QColor(value("fill"))));
    painter.setPen(value("stroke").isEmpty() ? QPen(Qt::NoPen)
                                             : QPen(QColor(value("stroke")), value("stroke-width").toDouble()));
    painter.drawPath(shape);
  }
  painter.end();
  return xml.hasError() ? QImage() : image;
}

}  // namespace

class GraphTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    QSettings().clear();
    write_cloud(at("cloud.xyz").toStdString());
    write_pipeline(at("plot.json").toStdString());
    QVERIFY(QFile::copy(QStringLiteral(BOLE_SOURCE_DIR) + "/pipelines/forest_plot.json", at("forest_plot.json")));
    window_ = std::make_unique<MainWindow>();
    window_->resize(1280, 720);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    QApplication::setActiveWindow(window_.get());  // no window manager does it under Xvfb
    QVERIFY(!window_->commands().action("graph.show")->isEnabled());
  }

  void cleanupTestCase() {
    window_->session().discard_recovery();
    window_.reset();
    QSettings().clear();
  }

  void boxes_keep_apart_and_arrows_point_forward() {
    for (unsigned seed = 1; seed <= 40; ++seed)
      for (const auto orientation : {Qt::Horizontal, Qt::Vertical}) {
        const std::size_t boxes = 1 + seed % 25;
        const auto arrows = random_arrows(boxes, static_cast<int>(seed), seed);
        const auto layout = lay_out_graph(boxes, arrows, box_size, spacing, orientation);
        QCOMPARE(layout.boxes.size(), boxes);
        const QString fault = fault_of(layout, arrows, orientation);
        QVERIFY2(fault.isEmpty(), qPrintable(QString("graph %1: %2").arg(seed).arg(fault)));
        const auto again = lay_out_graph(boxes, arrows, box_size, spacing, orientation);
        QVERIFY(again.boxes == layout.boxes && again.arrows == layout.arrows);
      }
    QVERIFY(lay_out_graph(0, {}, box_size, spacing, Qt::Horizontal).boxes.empty());
  }

  void arrows_that_need_not_cross_do_not() {
    const std::vector<GraphArrow> crossed{{0, 5}, {1, 4}, {2, 3}, {0, 4}, {2, 4}};
    QCOMPARE(crossings(lay_out_graph(6, crossed, box_size, spacing, Qt::Horizontal), crossed), 0);
  }

  void an_arrow_that_passes_layers_is_straight() {
    const std::vector<GraphArrow> arrows{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {0, 4}};
    const auto layout = lay_out_graph(5, arrows, box_size, spacing, Qt::Horizontal);
    const auto& way = layout.arrows.back();
    QCOMPARE(way.size(), std::size_t{8});
    for (std::size_t i = 1; i + 1 < way.size(); ++i) QVERIFY(std::abs(way[i].y() - way[1].y()) < 4);
  }

  void a_source_stands_before_what_takes_from_it() {
    const std::vector<GraphArrow> arrows{{0, 1}, {1, 2}, {2, 3}, {4, 3}};
    QCOMPARE(lay_out_graph(5, arrows, box_size, spacing, Qt::Horizontal).layers[4], 2);
  }

  void a_circle_is_drawn_too() {
    const auto layout = lay_out_graph(3, {{0, 1}, {1, 2}, {2, 0}}, box_size, spacing, Qt::Horizontal);
    QCOMPARE(layout.layers, (std::vector<int>{0, 1, 2}));
    QCOMPARE(layout.arrows[2].size(), std::size_t{2});
  }

  void every_stage_has_a_box() {
    open("forest_plot.json");
    const auto& document = window_->session().document();
    QCOMPARE(view().boxes().size(), document.stages().size());
    std::set<std::pair<std::string, std::string>> joined;
    for (const auto& node : document.stages()) {
      const auto* box = view().box(QString::fromStdString(node.id));
      QVERIFY2(box != nullptr, node.id.c_str());
      QVERIFY(!box->look().title.isEmpty() && !box->look().state.isEmpty());
      for (const auto& [port, source] : node.inputs) joined.emplace(source.substr(0, source.find('.')), node.id);
    }
    QCOMPARE(view().arrows().size(), joined.size());
    std::vector<GraphArrow> arrows;
    for (const auto& join : view().graph().joins) arrows.push_back({join.from, join.to});
    for (const auto orientation : {Qt::Horizontal, Qt::Vertical}) {
      const auto layout = lay_out_graph(view().boxes().size(), arrows, box_size, spacing, orientation);
      QVERIFY2(fault_of(layout, arrows, orientation).isEmpty(), qPrintable(fault_of(layout, arrows, orientation)));
    }
    // The list says the same.
    QCOMPARE(view().box("slam")->look().title, window_->pipeline().topLevelItem(1)->text(0));
    QCOMPARE(view().box("track")->look().state, QString("skipped"));
    QCOMPARE(view().box("slam")->look().state, QString("not run"));
    QCOMPARE(view().box("scan")->look().state, QString("cannot run"));  // no file is given
    QVERIFY(view().tip_of(*view().box("scan")).contains("file"));
  }

  void an_arrow_names_all_that_it_carries() {
    open("forest_plot.json");
    const auto& joins = view().graph().joins;
    const auto loops = std::ranges::find_if(joins, [&](const auto& j) {
      return view().graph().stages[j.from].id == "slam" && view().graph().stages[j.to].id == "loops";
    });
    QVERIFY(loops != joins.end());
    const QString words = view().graph().words(*loops, {});
    for (const char* port : {"points: point cloud", "trajectory: trajectory", "odometry", "loop_candidates: table"})
      QVERIFY2(words.contains(port), qPrintable(words));
    const auto renamed = std::ranges::find_if(joins, [&](const auto& j) {
      return view().graph().stages[j.from].id == "reference_trees" && view().graph().stages[j.to].id == "report";
    });
    QVERIFY(view().graph().words(*renamed, {}).contains(QStringLiteral("table → reference_stems")));
    // Where it stands: an arrow leaves the first stage in its middle.
    const auto* scan = view().box("scan");
    const double ahead = 0.8 * scan->frame().height() / 4;
    const QPointF at = view().orientation() == Qt::Horizontal
                           ? scan->mapToScene(QPointF(scan->frame().right() + ahead, scan->frame().center().y()))
                           : scan->mapToScene(QPointF(scan->frame().center().x(), scan->frame().bottom() + ahead));
    QVERIFY2(view().tip_at(at).contains("frames"), qPrintable(view().tip_at(at)));
  }

  void the_selection_is_that_of_the_list() {
    open("forest_plot.json");
    window_->pipeline().select_stage("slice");
    QCOMPARE(selected(), QStringList{"slice"});
    click("stems");
    QCOMPARE(window_->pipeline().current_stage(), QString("stems"));
    QCOMPARE(selected(), QStringList{"stems"});
    int lit = 0, joined = 0;
    for (const auto* arrow : view().arrows()) {
      lit += arrow->lit();
      joined += view().boxes()[arrow->from()]->stage() == "stems" || view().boxes()[arrow->to()]->stage() == "stems";
    }
    QVERIFY(lit > 3);
    QCOMPARE(lit, joined);
  }

  void keys_go_along_the_arrows() {
    open("forest_plot.json");
    QTest::keyClick(window_.get(), Qt::Key_G, Qt::ControlModifier);
    QTRY_VERIFY(view().hasFocus());
    QVERIFY(window_->docks().find("graph")->isVisible());
    const bool wide = view().orientation() == Qt::Horizontal;
    const auto on = wide ? Qt::Key_Right : Qt::Key_Down, back = wide ? Qt::Key_Left : Qt::Key_Up;
    const auto aside = wide ? Qt::Key_Down : Qt::Key_Right, other = wide ? Qt::Key_Up : Qt::Key_Left;
    window_->pipeline().select_stage("scan");
    const QImage focused = view().grab().toImage();
    view().clearFocus();
    QVERIFY(view().grab().toImage() != focused);  // a person sees where the keys go
    view().setFocus();
    for (const char* id : {"slam", "loops", "frame"}) {
      QTest::keyClick(&view(), on);
      QCOMPARE(selected(), QStringList{id});
    }
    QTest::keyClick(&view(), back);
    QCOMPARE(selected(), QStringList{"loops"});
    // Every stage can be reached.
    std::set<QString> reached{"scan"}, fresh = reached;
    while (!fresh.empty()) {
      std::set<QString> next;
      for (const auto& id : fresh)
        for (const auto key : {on, back, aside, other}) {
          window_->pipeline().select_stage(id);
          QTest::keyClick(&view(), key);
          if (reached.insert(window_->pipeline().current_stage()).second)
            next.insert(window_->pipeline().current_stage());
        }
      fresh = next;
    }
    QCOMPARE(reached.size(), view().boxes().size());
    window_->pipeline().select_stage("slice");
    QTest::keyClick(&view(), Qt::Key_Return);
    QVERIFY(window_->properties().isAncestorOf(QApplication::focusWidget()));
    QVERIFY(window_->properties().isVisible());
  }

  void edits_are_followed_at_once() {
    open("plot.json");
    QCOMPARE(view().boxes().size(), std::size_t{5});
    window_->pipeline().select_stage("edit");
    window_->pipeline().add_stage("survey.plot");
    QCOMPARE(view().boxes().size(), std::size_t{6});
    QCOMPARE(selected(), QStringList{"plot"});
    window_->pipeline().rename_stage("stems", "boles");
    QVERIFY(view().box("boles") != nullptr && view().box("stems") == nullptr);
    const auto arrows = view().arrows().size();
    auto other = window_->session().document();
    for (auto& node : other.stages())
      if (node.id == "boles") node.inputs.erase("dem");
    window_->session().change("no terrain", std::move(other));
    QCOMPARE(view().arrows().size(), arrows);  // its points come from there too
    window_->pipeline().delete_stage("slice");
    QCOMPARE(view().boxes().size(), std::size_t{5});
    // What must be connected and is not stands in the box.
    const auto* boles = view().box("boles");
    QCOMPARE(boles->look().missing, QStringList{"dem"});
    QCOMPARE(boles->look().state, QString("needs dem"));
    QVERIFY(view().tip_of(*boles).contains("dem"));
    window_->session().undo_stack().setIndex(0);
    QCOMPARE(view().boxes().size(), std::size_t{5});
    QVERIFY(view().box("slice") != nullptr && view().box("stems")->look().missing.isEmpty());
  }

  void boxes_say_how_the_run_went() {
    open("plot.json");
    std::set<QString> seen;
    const auto watch = connect(&window_->runner(), &Runner::progressed, this, [&](const QString& stage) {
      seen.insert(stage);
      QVERIFY(view().box(stage)->look().mark == StageMark::running);
      QVERIFY(view().box(stage)->look().state.startsWith("running"));
    });
    stems::StemEdit nowhere;  // fits no stem, which is a warning
    nowhere.action = stems::StemEdit::Action::remove;
    nowhere.at = {500, 500};
    add_edits(window_->session(), std::vector{nowhere});
    window_->refresh();
    QVERIFY(wait_for_run(*window_));
    disconnect(watch);
    QVERIFY(!seen.empty());
    int warnings = 0;
    for (const auto& stage : window_->runner().outcome().stages) {
      const auto& look = view().box(QString::fromStdString(stage.record.id))->look();
      const auto n = static_cast<int>(stage.record.report.warnings.size());
      warnings += n;
      QCOMPARE(look.warnings, n);
      QVERIFY(look.mark == (n == 0 ? StageMark::done : StageMark::warning));
      const QString words = n == 0 ? QString("done") : n == 1 ? QString("1 warning") : QString("%1 warnings").arg(n);
      QVERIFY2(look.state.startsWith(words + QStringLiteral(" · ")) && look.state.endsWith(" s"),
               qPrintable(look.state));
      for (const auto& warning : stage.record.report.warnings)
        QVERIFY(view()
                    .tip_of(*view().box(QString::fromStdString(stage.record.id)))
                    .contains(QString::fromStdString(warning)));
    }
    QVERIFY(warnings > 0);  // else the count was not tried
    // The arrays of the results.
    const auto& graph = view().graph();
    const QString cloud = graph.words(graph.joins.front(), window_->runner().results());
    QVERIFY2(cloud.contains("array"), qPrintable(cloud));
    // What follows from a changed option is out of date, in the list too, until the change is undone.
    window_->session().set_option("slice", "thickness", 0.2);
    for (const auto& [id, stale] : {std::pair("ground", false), {"slice", true}, {"stems", true}, {"edit", true}}) {
      QCOMPARE(view().box(id)->look().mark == StageMark::outdated, stale);
      QCOMPARE(view().box(id)->look().state == "out of date", stale);
      QCOMPARE(list_state(id) == "out of date", stale);
    }
    window_->session().undo_stack().undo();
    QVERIFY(view().box("edit")->look().mark != StageMark::outdated);
    // A name changes nothing.
    window_->pipeline().rename_stage("slice", "cut");
    QVERIFY(view().box("cut")->look().mark == StageMark::done || view().box("cut")->look().mark == StageMark::warning);
    QVERIFY(view().box("stems")->look().mark != StageMark::outdated);
    window_->session().undo_stack().undo();
    open("plot.json");
    QCOMPARE(view().box("slice")->look().state, QString("not run"));
  }

  void a_failure_is_seen() {
    std::ofstream(at("broken.xyz").toStdString()) << "this is no cloud\n";
    open("plot.json");
    window_->session().set_option("scan", "file", at("broken.xyz").toStdString());
    window_->refresh();
    QVERIFY(wait_for_run(*window_));
    QVERIFY(view().box("scan")->look().mark == StageMark::failed);
    QCOMPARE(view().box("scan")->look().state, QString("failed"));
    QVERIFY(view().tip_of(*view().box("scan")).contains("broken.xyz"));
    QVERIFY(view().box("slice")->look().mark == StageMark::idle);
    QVERIFY(view().tip_of(*view().box("slice")).contains("ground"));
    window_->session().undo_stack().undo();
  }

  void all_of_it_is_seen_and_the_wheel_zooms() {
    open("forest_plot.json");
    window_->commands().trigger("graph.show");
    const auto whole = [&] {
      return view().viewport()->rect().contains(
          view().mapFromScene(view().scene()->itemsBoundingRect()).boundingRect());
    };
    auto* dock = window_->docks().find("graph");
    QTRY_VERIFY(whole());
    dock->setFloating(true);
    dock->resize(1200, 300);
    QTRY_COMPARE(view().orientation(), Qt::Horizontal);
    QTRY_VERIFY(whole());
    dock->resize(420, 680);
    QTRY_COMPARE(view().orientation(), Qt::Vertical);
    QTRY_VERIFY(whole());
    const double before = view().transform().m11();
    const QPoint middle = view().viewport()->rect().center();
    QWheelEvent wheel(middle, view().viewport()->mapToGlobal(middle), {}, {0, 480}, Qt::NoButton, {}, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(view().viewport(), &wheel);
    QVERIFY(view().transform().m11() > 1.5 * before && !whole());
    dock->resize(430, 690);  // what a person zoomed to stays
    QTest::qWait(20);
    QVERIFY(view().transform().m11() > 1.5 * before);
    QApplication::setActiveWindow(view().window());
    view().setFocus();
    QTRY_VERIFY(view().hasFocus());
    QTest::keyClick(&view(), Qt::Key_0, Qt::ControlModifier);
    QTRY_VERIFY(whole());
    QApplication::sendEvent(view().viewport(), &wheel);
    QVERIFY(!whole());
    QTest::mouseDClick(view().viewport(), Qt::LeftButton, {}, middle);
    QTRY_VERIFY(whole());
    dock->setFloating(false);
    QApplication::setActiveWindow(window_.get());
  }

  void keys_of_the_list_work_here() {
    open("plot.json");
    window_->commands().trigger("graph.show");
    view().setFocus();
    window_->pipeline().select_stage("slice");
    QTest::keyClick(&view(), Qt::Key_D, Qt::ControlModifier);
    QVERIFY(view().box("slice_2") != nullptr);
    window_->session().undo_stack().undo();
  }

  void a_picture_is_saved_white_and_without_the_selection() {
    open("forest_plot.json");
    window_->pipeline().select_stage("frame");
    view().save(at("graph.svg"));
    view().save(at("graph.png"));
    const QImage png(at("graph.png")), svg = drawn_svg(at("graph.svg"));
    QCOMPARE(std::max(png.width(), png.height()), 3840);
    QVERIFY(!svg.isNull());
    QCOMPARE(png.pixelColor(2, 2), QColor(Qt::white));
    const QImage small = png.scaled(svg.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    const QSize coarse = svg.size() / 4;
    const auto blurred = [&](const QImage& image) {
      return image.scaled(coarse, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    };
    QImage paper(coarse, QImage::Format_RGB32);
    paper.fill(Qt::white);
    const double ink = difference(blurred(small), paper), apart = difference(blurred(small), blurred(svg));
    QVERIFY2(ink > 0.02 && apart < 0.1 * ink, qPrintable(QString("%1 of %2").arg(apart).arg(ink)));
    apply_theme(Theme::dark);
    window_->pipeline().select_stage("slam");
    view().save(at("dark.png"));
    apply_theme(Theme::light);
    QVERIFY(difference(QImage(at("dark.png")), png) < 1e-6);  // arrows that cross may be drawn in another order
    QVERIFY_EXCEPTION_THROWN(view().save(at("cloud.xyz/graph.png")), Error);
  }

  void it_follows_the_theme() {
    open("forest_plot.json");
    window_->commands().trigger("graph.show");
    const auto paper = [&] { return view().grab().toImage().pixelColor(3, 3).lightness(); };
    apply_theme(Theme::light);
    QVERIFY(paper() > 240);
    apply_theme(Theme::dark);
    QVERIFY(paper() < 60);
    apply_theme(Theme::light);
  }

  // BOLE_LOOK=FOLDER writes what a person should look at.
  void pictures_to_look_at() {
    const QString to = qEnvironmentVariable("BOLE_LOOK");
    if (to.isEmpty()) QSKIP("BOLE_LOOK is not set");
    for (const QString language : {"en", "zh_CN"})
      for (const auto theme : {Theme::light, Theme::dark}) {
        install_language(*QCoreApplication::instance(), language);
        apply_theme(theme);
        MainWindow window;
        window.resize(1280, 720);
        for (const auto& mode : shipped_modes())
          if (mode.id == "teacher") apply_mode(window, mode);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        const QString name = QString("%1/%2_%3_").arg(to, language, theme == Theme::dark ? "dark" : "light");
        auto& graph = *window.findChild<GraphView*>();
        window.open(at("plot.json"));
        window.refresh();
        QVERIFY(wait_for_run(window));
        window.session().set_option("slice", "thickness", 0.2);
        window.commands().trigger("graph.show");
        QTest::qWait(200);
        window.grab().save(name + "1_plot.png");
        window.session().undo_stack().undo();
        auto broken = window.session().document();
        for (auto& node : broken.stages())
          if (node.id == "stems") node.inputs = {{"slice", "slice.slice"}};
        window.session().change("broken", std::move(broken));
        window.pipeline().select_stage("stems");
        graph.setFocus();
        graph.grab().save(name + "1_broken.png");
        window.session().undo_stack().undo();
        window.open(at("forest_plot.json"));
        window.pipeline().select_stage("frame");
        QTest::qWait(200);
        window.grab().save(name + "2_window.png");
        auto* dock = window.docks().find("graph");
        dock->setFloating(true);
        for (const QSize size : {QSize(1280, 640), QSize(700, 760), QSize(1900, 620)}) {
          dock->resize(size);
          QTest::qWait(100);
          graph.grab().save(name + QString("3_%1.png").arg(size.width()));
        }
        graph.save(name + "4_saved.svg");
        graph.save(name + "4_saved.png");
        window.session().discard_recovery();
      }
    apply_theme(Theme::light);
    install_language(*QCoreApplication::instance(), "en");
  }

 private:
  QString at(const char* name) const { return folder_.filePath(name); }
  GraphView& view() { return *window_->findChild<GraphView*>(); }

  void open(const char* document) {
    window_->session().discard_recovery();
    window_->session().undo_stack().setIndex(0);
    window_->session().undo_stack().setClean();
    window_->open(at(document));
  }

  QStringList selected() {
    QStringList ids;
    for (const auto* box : view().boxes())
      if (box->current()) ids << box->stage();
    return ids;
  }

  void click(const char* id) {
    window_->commands().trigger("graph.show");
    const auto* box = view().box(id);
    const QPoint place = view().mapFromScene(box->mapToScene(box->frame().center()));
    QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, place);
  }

  QString list_state(const char* id) {
    auto& panel = window_->pipeline();
    const auto& stages = window_->session().document().stages();
    const auto row = std::ranges::find(stages, id, &pipeline::StageNode::id) - stages.begin();
    return panel.topLevelItem(static_cast<int>(row))->text(PipelinePanel::state_column);
  }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace bole::desktop

int run_graph_test(int argc, char** argv) {
  bole::desktop::GraphTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "graph_test.moc"
