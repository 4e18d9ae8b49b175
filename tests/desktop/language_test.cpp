// Every string of the window has its Chinese translation, and plural forms are English.
#include <QApplication>
#include <QDockWidget>
#include <QFile>
#include <QMenuBar>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTranslator>
#include <QXmlStreamReader>
#include <cmath>

#include "base/arrays.h"
#include "document/cell_words.h"
#include "document/stage_words.h"
#include "features/lesson/lesson_reader.h"
#include "features/lesson/lesson_words.h"
#include "features/stem_review/stem_review.h"
#include "io/core/formats.h"
#include "look/array_words.h"
#include "look/language.h"
#include "render/beside/distance_bars.h"
#include "render/charts/cross_section.h"
#include "render/charts/linked_charts.h"
#include "render/charts/row_profile.h"
#include "render/charts/stem_profile.h"
#include "render/charts/stem_slice.h"
#include "render/charts/trajectory_charts.h"
#include "render/scene/view_furniture.h"
#include "shell/main_window.h"
#include "shell_test.h"
#include "stems/core/fit/stem_reasons.h"
#include "stems/core/tree/tree_tops.h"
#include "views/figure_picture.h"

namespace bole::desktop {
namespace {

// The texts of one .ts file in Chinese; what it lacks is listed.
class ChineseFile {
 public:
  explicit ChineseFile(const QString& name) : name_(name), loaded_(texts_.load(name + "_zh_CN", ":/i18n")) {}

  bool loaded() const { return loaded_; }
  QString needed(const char* context, const QByteArray& text, const std::string& comment = {}) {
    const QString chinese = texts_.translate(context, text.constData(), comment.c_str());
    if (chinese.isEmpty()) missing_ << QString(context) + ": " + QString::fromUtf8(text);
    return chinese;
  }
  QString report() const { return "translate in app/desktop/i18n/" + name_ + "_zh_CN.ts:\n" + missing_.join('\n'); }
  bool complete() const { return missing_.isEmpty(); }

 private:
  QString name_;
  QTranslator texts_;
  bool loaded_;
  QStringList missing_;
};

// Numbers and names of options or columns that the translation lacks.
QStringList lost(const QString& english, const QString& chinese) {
  static const QRegularExpression kept("[0-9]+(\\.[0-9]+)?(?!-D)|[a-z0-9]+(_[a-z0-9]+)+");
  QStringList words;
  for (auto found = kept.globalMatch(english); found.hasNext();)
    if (const QString word = found.next().captured(); !chinese.contains(word)) words << word + " in: " + chinese;
  return words;
}

}  // namespace

class LanguageTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QSettings().clear(); }
  void cleanup() { install_language(*QCoreApplication::instance(), "en"); }

  // lupdate on the sources as they are: what it finds and the committed file lacks is untranslated.
  void no_string_is_untranslated() {
    const QString lupdate = QString(BOLE_LUPDATE);
    if (!QFile::exists(lupdate)) QSKIP("lupdate (qttools5-dev-tools) is absent");
    QTemporaryDir folder;
    const QString source = QStringLiteral(BOLE_SOURCE_DIR) + "/app/desktop";
    const QString copy = folder.filePath("bole_zh_CN.ts");
    QVERIFY(QFile::copy(source + "/i18n/bole_zh_CN.ts", copy));
    QProcess process;
    process.start(lupdate, {"-silent", "-recursive", source, "-extensions", "h,cpp", "-ts", copy});
    QVERIFY(process.waitForFinished(60000));
    QFile file(copy);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    QString text;
    QStringList untranslated;
    int strings = 0;
    while (!xml.atEnd()) {
      xml.readNext();
      if (!xml.isStartElement()) continue;
      if (xml.name() == QLatin1String("source")) text = xml.readElementText();
      if (xml.name() == QLatin1String("translation")) {
        ++strings;
        if (xml.attributes().value("type") == QLatin1String("unfinished")) untranslated << text;
      }
    }
    QVERIFY(!xml.hasError());
    QVERIFY(strings > 100);
    QVERIFY2(untranslated.isEmpty(),
             qPrintable("translate in app/desktop/i18n/bole_zh_CN.ts:\n" + untranslated.join('\n')));
  }

  // Placeholders and keys survive.
  void translations_keep_their_placeholders() {
    QFile file(QStringLiteral(BOLE_SOURCE_DIR) + "/app/desktop/i18n/bole_zh_CN.ts");
    QVERIFY(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    QString text;
    while (!xml.atEnd()) {
      xml.readNext();
      if (!xml.isStartElement()) continue;
      if (xml.name() == QLatin1String("source")) text = xml.readElementText();
      if (xml.name() != QLatin1String("translation")) continue;
      const QString translation = xml.readElementText(QXmlStreamReader::IncludeChildElements);
      for (const auto& mark : {"%1", "%2", "%3", "%n", "…"})
        QVERIFY2(text.contains(mark) == translation.contains(mark), qPrintable(text + " -> " + translation));
    }
  }

  void every_stage_is_translated() {
    install_language(*QCoreApplication::instance(), "en");  // it takes in the files
    ChineseFile stages("stages");
    QVERIFY(stages.loaded());
    QStringList words;
    for (const auto* type : pipeline::StageRegistry::global().all()) {
      stages.needed("stages", type->title.c_str());
      words << lost(QString::fromStdString(type->help), stages.needed("stage help", type->help.c_str()));
    }
    QVERIFY2(stages.complete(), qPrintable(stages.report()));
    QVERIFY2(words.isEmpty(), qPrintable(words.join('\n')));
  }

  void every_option_is_translated() {
    install_language(*QCoreApplication::instance(), "en");  // its labels are the keys of the others
    ChineseFile options("options");
    QVERIFY(options.loaded());
    QStringList words;
    int count = 0;
    for (const auto* type : pipeline::StageRegistry::global().all())
      for (const auto& spec : type->options->specs) {
        ++count;
        options.needed("option labels", option_label(*type, spec).toUtf8(), type->name);
        const auto help = help_sentence(spec);
        words << lost(QString::fromStdString(help), options.needed("option help", help.c_str()));
        for (const auto& choice : spec.choices) options.needed("choices", choice.c_str(), spec.name);
        if (!spec.unset.empty()) options.needed("choices", spec.unset.c_str(), spec.name);
      }
    QVERIFY(count > 100);
    QVERIFY2(options.complete(), qPrintable(options.report()));
    QVERIFY2(words.isEmpty(), qPrintable(words.join('\n')));
  }

  // The help of a reader names all its formats in both languages; the Chinese sentence has no list of its own.
  void lists_of_formats_are_those_of_the_table() {
    for (const auto content : io::all_contents) {
      const auto& type = pipeline::StageRegistry::global().at(io::stage_of(content));
      const auto& spec = type.options->specs.front();
      QVERIFY2(help_sentence(spec).ends_with("%1."), spec.help.c_str());
      install_language(*QCoreApplication::instance(), "en");
      QCOMPARE(option_help(spec).toStdString(), spec.help);
      install_language(*QCoreApplication::instance(), "zh_CN");
      const QString chinese = option_help(spec);
      QVERIFY2(chinese.startsWith(QStringLiteral("要读取的")) && !chinese.contains("%1"), qPrintable(chinese));
      for (const auto& [name, bracket] : io::listed_formats(content))
        for (const auto& text : {name, bracket})
          QVERIFY(chinese.contains(QCoreApplication::translate("formats", text.c_str())));
    }
    const auto& cloud = pipeline::StageRegistry::global().at("io.read_cloud").options->at("file");
    QVERIFY(option_help(cloud).startsWith(QStringLiteral("要读取的点云:COPC(.copc.laz)、LAZ、LAS、E57")));
    const auto& scan = pipeline::StageRegistry::global().at("io.read_scan").options->at("file");
    QVERIFY(option_help(scan).contains(QStringLiteral("或 帧文件夹(.bin, .pcd)")));
  }

  // No words of formats that are gone.
  void words_of_formats_are_in_the_table() {
    QSet<QString> known;
    for (const auto content : io::all_contents)
      for (const auto& [name, bracket] : io::listed_formats(content))
        known << QString::fromStdString(name) << QString::fromStdString(bracket);
    QFile file(QStringLiteral(BOLE_SOURCE_DIR) + "/app/desktop/i18n/options_zh_CN.ts");
    QVERIFY(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    QString context;
    while (!xml.atEnd()) {
      xml.readNext();
      if (!xml.isStartElement()) continue;
      if (xml.name() == QLatin1String("name")) context = xml.readElementText();
      if (xml.name() != QLatin1String("source") || context != "formats") continue;
      const QString text = xml.readElementText();
      QVERIFY2(known.contains(text), qPrintable(text));
    }
  }

  void every_lesson_is_translated() {
    install_language(*QCoreApplication::instance(), "en");
    ChineseFile lessons("lessons");
    QVERIFY(lessons.loaded());
    std::vector<std::string> problems;
    QStringList words;
    int count = 0;
    for (const auto& lesson : shipped_lessons(problems))
      for (const auto& text : lesson_texts(lesson)) {
        ++count;
        words << lost(QString::fromStdString(text), lessons.needed(lesson_context, text.c_str()));
      }
    QVERIFY(count > 100);
    QVERIFY2(lessons.complete(), qPrintable(lessons.report()));
    QVERIFY2(words.isEmpty(), qPrintable(words.join('\n')));
  }

  // A form in Chinese writes the English words of the choices into the document.
  void options_speak_chinese() {
    install_language(*QCoreApplication::instance(), "zh_CN");
    const auto& type = pipeline::StageRegistry::global().at("stems.measure");
    const auto& model = type.options->at("model");
    const auto& beam = type.options->at("beam_divergence");
    QCOMPARE(option_label(type, model), QStringLiteral("拟合模型"));
    QVERIFY(option_help(model).startsWith(QStringLiteral("联合拟合的残差")));
    QCOMPARE(value_words(model, std::string("auto")), QStringLiteral("自动"));
    QVERIFY(needed_words(model).endsWith(QStringLiteral("自动, 射线, 表面")));
    QCOMPARE(value_words(beam, beam.default_value), QStringLiteral("按点云"));
    QCOMPARE(typed_value(beam, QStringLiteral("按点云")), std::string("cloud"));
    QCOMPARE(typed_value(beam, "3"), std::string("3"));
    // The same word and the same option mean something else elsewhere.
    const auto& frame = pipeline::StageRegistry::global().at("survey.frame");
    const auto& plot = pipeline::StageRegistry::global().at("survey.plot");
    QVERIFY(choice_word(frame.options->at("level"), "none") != choice_word(plot.options->at("shape"), "none"));
    const auto& ground = pipeline::StageRegistry::global().at("ground.model");
    const auto& drive = pipeline::StageRegistry::global().at("steering.simulate");
    QVERIFY(option_label(ground, ground.options->at("seed")) != option_label(drive, drive.options->at("seed")));
  }

  // What the charts and the 3-D view write has its Chinese words; numbers stay.
  void figures_speak_chinese() {
    install_language(*QCoreApplication::instance(), "zh_CN");
    const auto look = screen_look(QPalette());
    QStringList english;
    auto listening = look;
    listening.words = [&](std::string_view text) {
      const QString shown = QString::fromStdString(look.words(text));
      QString rest = shown;
      for (const char* unit : {"RMSE", "north"}) rest.remove(unit);
      if (rest.contains(QRegularExpression("[A-Za-z]{3,}"))) english << shown;
      return shown.toStdString();
    };
    Table stems, matches;
    stems.set("tree_id", std::vector<std::int64_t>{1, 2});
    stems.set("dbh_cm", std::vector<double>{20, 31});
    stems.set("height_m", std::vector<double>{15, 21});
    stems.set("height_seen", std::vector<double>{1, 0});
    matches.set("kind", std::vector<std::string>{"matched", "matched"});
    matches.set("tree_id", std::vector<double>{1, 2});
    matches.set("dbh_cm", std::vector<double>{20, 31});
    matches.set("ref_dbh_cm", std::vector<double>{20.5, 30});
    Trajectory path;
    for (int i = 0; i < 3; ++i) {
      StampedPose pose;
      pose.time_s = i;
      pose.T_target_sensor.translation().x() = i;
      path.poses.push_back(pose);
    }
    render::StemSliceData slice;
    render::StemProfileData profile;
    std::vector<render::Figure> figures{render::stem_slice(slice, 80, 80), render::stem_profile(profile, 60, 90),
                                        render::trajectory_error_chart({&path, &path, nullptr}, 120),
                                        render::cross_section({}, {}, 120, 80, 96, 1)};
    std::vector<render::RowPlant> row(4);
    for (std::size_t k = 0; k < row.size(); ++k) {
      row[k].at.x() = row[k].along_m = static_cast<double>(k);
      row[k].missing = k == 2;
    }
    figures.push_back(render::row_profile({{}, row}, 80, 60));
    figures.push_back(render::plant_distances(row, {}, {}).figure);
    render::DistanceBars bars;
    bars.within_m = bars.median_m = 2;
    figures.push_back(render::distance_histogram(bars, {}));  // of nothing
    bars.bin_m = 0.1;
    bars.counts = {20000, 10000};
    bars.compared = 30011;
    for (const std::size_t outside : {std::size_t{2}, std::size_t{2000}})
      for (const auto of : {render::DistanceBars::Of::nearest_point, render::DistanceBars::Of::surface,
                            render::DistanceBars::Of::height}) {
        bars.of = of;
        bars.below = bars.above = bars.unmatched = outside;
        bars.lo_m = bars.lo95_m = bars.median_m = of == render::DistanceBars::Of::height ? -0.1 : 0;
        figures.push_back(render::distance_histogram(bars, {}));
        bars.median_m = bars.hi95_m = of == render::DistanceBars::Of::height ? 0.1 : HUGE_VAL;
        figures.push_back(render::distance_histogram(bars, {}));
        bars.hi95_m = 0.1;
      }
    const Table no_stems = stems.subset({}), no_matches;
    for (const auto& chart : render::linked_charts()) {
      figures.push_back(chart.draw({&stems, &matches}, {}, {}).figure);
      figures.push_back(chart.draw({&no_stems, &no_matches}, {}, {}).figure);
      listening.words(chart.title);
    }
    render::ViewFurniture furniture;
    furniture.width_mm = 200;
    furniture.height_mm = 150;
    furniture.mm_per_metre = 5;
    furniture.paint = render::PointPaint();
    furniture.paint->title = "tree id";
    furniture.tree_legend = true;
    furniture.trees.resize(3);
    for (const int k : {0, 1, 2}) {
      furniture.trees[static_cast<std::size_t>(k)].quality =
          std::array{"good", "fair", "poor"}[static_cast<std::size_t>(k)];
      furniture.trees[static_cast<std::size_t>(k)].state =
          std::array{"", "accepted", "rejected"}[static_cast<std::size_t>(k)];
    }
    for (const double contour_step_m : {0.0, 0.5}) {
      furniture.contour_step_m = contour_step_m;
      for (const bool perspective : {true, false})
        for (const double grid_step_m : {0.0, 2.0}) {
          furniture.perspective = perspective;
          furniture.grid_step_m = grid_step_m;
          for (auto& patch : render::furniture_patches(furniture)) figures.push_back(patch.figure);
        }
    }
    for (const auto& figure : figures) render::screen_overlay(figure, 96, listening);
    QVERIFY2(english.isEmpty(), qPrintable("translate in app/desktop/i18n/figures_zh_CN.ts:\n" + english.join('\n')));
    QCOMPARE(QString::fromStdString(look.words("n 12   bias -0.20 cm   RMSE 0.41 cm")),
             QStringLiteral("n 12   偏差 -0.20 cm   RMSE 0.41 cm"));
    QCOMPARE(look.words("Tree 7"), std::string("Tree 7"));
  }

  void what_colours_points_has_chinese_words() {
    install_language(*QCoreApplication::instance(), "zh_CN");
    for (const auto& array : array_vocabulary()) {
      const QString words = array_words(std::string(array.name));
      QVERIFY2(std::any_of(words.begin(), words.end(), [](QChar c) { return c.unicode() >= 0x4e00; }),
               qPrintable(words));
    }
    QCOMPARE(array_words("leaf_water"), QString("leaf water"));
  }

  // Every sentence that the measurement can give as a reason, and every word of the columns beside it.
  void the_stem_table_speaks_chinese() {
    install_language(*QCoreApplication::instance(), "zh_CN");
    QStringList sentences;
    for (const auto& format : stems::stem_reason_formats())
      for (const QString number : {"12.3", "7"}) {
        QString sentence = QString::fromUtf8(format.data(), static_cast<int>(format.size()));
        sentences << sentence.replace(QRegularExpression("\\{[^}]*\\}"), number);
      }
    QStringList english;
    const auto check = [&](const char* column, const QString& text) {
      const QString shown = cell_words(column, text);
      if (shown.contains(QRegularExpression("[A-Za-z]{3,}")) || !lost(text, shown).isEmpty()) english << text;
    };
    for (const auto& sentence : sentences) check("reasons", sentence);
    for (const auto top : choice_names(stems::TopVerdict{})) check("top", QString::fromUtf8(top.data()));
    check("top", "given by hand");
    for (const char* word : {"good", "fair", "poor"}) check("quality", word);
    for (const char* word : {"auto", "check", "accepted", "rejected", "edited"}) check("state", word);
    QVERIFY2(english.isEmpty(), qPrintable("translate in app/desktop/i18n/stems_zh_CN.ts:\n" + english.join('\n')));
    QCOMPARE(cell_words("reasons", "leans 17 deg; wide interval: +-7.7 cm"),
             QStringLiteral("倾斜 17 度; 置信区间宽:+-7.7 cm"));
    QCOMPARE(cell_words("species", "poor"), QString("poor"));
  }

  void the_window_speaks_chinese() {
    install_language(*QCoreApplication::instance(), "zh_CN");
    QCOMPARE(current_language(), QString("zh_CN"));
    MainWindow window;
    QVERIFY(window.menuBar()->actions().front()->text().startsWith(QStringLiteral("文件")));
    QCOMPARE(window.docks().find("stems")->windowTitle(), QStringLiteral("单木"));
    const QRegularExpression english("[A-Za-z]{4,}");
    const QStringList names{"Bole", "English"};
    for (auto* action : window.findChildren<QAction*>()) {
      QString text = action->text();
      for (const auto& name : names) text.remove(name);
      QVERIFY2(!text.contains(english), qPrintable(text));
    }
  }

  void plurals_are_english() {
    install_language(*QCoreApplication::instance(), "en");
    QCOMPARE(StemReview::tr("%n stem(s) not decided yet", nullptr, 1), QString("1 stem not decided yet"));
    QCOMPARE(StemReview::tr("%n stem(s) not decided yet", nullptr, 3), QString("3 stems not decided yet"));
  }
};

int run_language_test(int argc, char** argv) {
  LanguageTest test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace bole::desktop
#include "language_test.moc"
