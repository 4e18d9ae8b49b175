// Films and pictures show the clouds beside the survey as the 3-D view does: place, colour, opacity, visibility.
#include <QCheckBox>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <algorithm>

#include "clouds_window.h"
#include "features/clouds/cloud_panel.h"
#include "features/flythrough/flythrough.h"
#include "short_film.h"

namespace bole::desktop {

class CloudFilmTest : public CloudsWindow {
  Q_OBJECT

 private Q_SLOTS:
  void a_film_shows_a_cloud_as_the_view_does() {
    const auto alone = film("alone", true);
    QCOMPARE(alone.size(), std::size_t{3});
    const int id = add("beside.ply");
    clouds().place(id, shifted(-7, 1.5, 0.4, 20));
    clouds().paint(id, magenta, {}, 0);
    QVERIFY(drawn(id) > 0);
    const auto with = film("with", true);
    for (std::size_t k = 0; k < with.size(); ++k) {
      QVERIFY(with[k] != alone[k]);
      QCOMPARE(in_magenta(alone[k]), 0);
      QVERIFY2(in_magenta(with[k]) > 100, QByteArray::number(in_magenta(with[k])));
    }
    // Where it is placed: beyond the plot, on the side of larger x, which is on the right.
    QVERIFY(mean_x(with[0]) > 0.5 * with[0].width());
    clouds().place(id, shifted(-33, 1.5, 0.4, 20));
    const auto moved = film("moved", true);
    QVERIFY2(mean_x(moved[0]) < 0.5 * moved[0].width(), QByteArray::number(mean_x(moved[0])));
    clouds().place(id, shifted(-7, 1.5, 0.4, 20));
    // A third of its opacity is about a third of its pixels.
    clouds().fade(id, 0.3);
    const auto faded = film("faded", true);
    const double share = double(in_magenta(faded[0])) / in_magenta(with[0]);
    QVERIFY2(faded[0] != with[0] && share < 0.6, QByteArray::number(share));
    clouds().fade(id, 1);
    // Not wished, not drawn.
    QVERIFY(film("left_out", false) == alone);
    clouds().show(id, false);
    QVERIFY(film("hidden", true) == alone);
    clouds().show(id, true);
    QVERIFY(film("again", true) == with);
    // Colours of an array.
    clouds().paint(id, magenta, "intensity", 0);
    const auto coloured = film("coloured", true);
    QVERIFY(coloured[0] != with[0] && coloured[0] != alone[0]);
    QCOMPARE(in_magenta(coloured[0]), 0);
  }

  void the_dialog_says_which_clouds_the_film_shows() {
    add("earlier.ply");
    QString said, without;
    bool ticked = false;
    QTimer::singleShot(0, this, [&] {
      auto* dialog = window_->findChild<FlythroughDialog*>();
      auto* box = dialog->findChild<QCheckBox*>("flythrough_clouds");
      ticked = box->isEnabled() && box->isChecked();
      said = dialog->findChild<QLabel*>("flythrough_clouds_said")->text();
      box->setChecked(false);
      without = dialog->findChild<QLabel*>("flythrough_clouds_said")->text();
      dialog->reject();
    });
    window_->commands().trigger("view.flythrough");
    QVERIFY(ticked);
    QCOMPARE(said, QString("With earlier.ply"));
    QVERIFY(without.isEmpty());
    FlythroughDialog none(scene().survey(), {}, {}, window_.get());
    QVERIFY(!none.findChild<QCheckBox*>("flythrough_clouds")->isEnabled());
  }

  void a_picture_of_the_view_shows_them_too() {
    look_from_the_south();
    QVERIFY(in_magenta(picture()) == 0);
    const int id = add("beside.ply");
    clouds().place(id, shifted(-7, 1.5, 0.4, 20));
    clouds().paint(id, magenta, {}, 0);
    look_from_the_south();
    QVERIFY(in_magenta(picture()) > 100);
    clouds().show(id, false);
    QVERIFY(in_magenta(picture()) == 0);
  }

 private:
  static constexpr render::Color magenta{1, 0, 1};

  // Shaded or not; the darkest colour of heights is a purple with a difference of 67.
  static bool is_magenta(QRgb c) { return std::min(qRed(c), qBlue(c)) > qGreen(c) + 80; }
  static int in_magenta(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) count += is_magenta(image.pixel(x, y));
    return count;
  }
  static double mean_x(const QImage& image) {
    double sum = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        if (is_magenta(image.pixel(x, y))) sum += x;
    return sum / in_magenta(image);
  }

  // All of the plot and 20 m to both sides of it.
  void look_from_the_south() {
    scene().look_along({0, 1, -0.4}, Eigen::Vector3d::UnitZ());
    scene().zoom_to(render::ClipBox{{-16, 0, 0}, {26, 10, 5}});
  }

  // Three frames, through two views that are nearly the same.
  std::vector<QImage> film(const char* name, bool with_clouds) {
    look_from_the_south();
    FlythroughDialog dialog(scene().survey(), short_course(scene(), {0.5, 0, 0.2}), short_film(), window_.get(),
                            scenery_of(scene()));
    auto* box = dialog.findChild<QCheckBox*>("flythrough_clouds");
    if (box->isEnabled()) box->setChecked(with_clouds);
    QSignalSpy made(&dialog, &FlythroughDialog::made);
    dialog.start(at(name));
    for (int wait = 0; wait < 6000 && dialog.busy(); ++wait) QTest::qWait(10);
    std::vector<QImage> frames;
    for (int k = 1; k <= 3; ++k) frames.emplace_back(at(name) + QString("/flythrough/frame_0000%1.png").arg(k));
    if (const QString look = qEnvironmentVariable("BOLE_LOOK"); !look.isEmpty())
      frames.front().save(look + "/film_" + name + ".png");
    return made.size() == 1 ? frames : std::vector<QImage>();
  }
};

}  // namespace bole::desktop

int bole::desktop::run_cloud_film_test(int argc, char** argv) {
  bole::desktop::CloudFilmTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "cloud_film_test.moc"
