#include "features/view_tools/fly.h"

#include <QCursor>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr int fly_section = 0;  // of the menu View
constexpr int frame_ms = 16, longest_step_ms = 100;
constexpr double walking_m_s = 1.4, min_m_s = 0.1, max_m_s = 50, speed_per_notch = 1.25, rad_per_px = 0.004;

// Keys of one direction each.
struct Direction {
  int letter, arrow;
  double right, ahead;
};
constexpr Direction directions[] = {{Qt::Key_W, Qt::Key_Up, 0, 1},
                                    {Qt::Key_S, Qt::Key_Down, 0, -1},
                                    {Qt::Key_A, Qt::Key_Left, -1, 0},
                                    {Qt::Key_D, Qt::Key_Right, 1, 0}};
constexpr int up_key = Qt::Key_PageUp, down_key = Qt::Key_PageDown;

bool moves(int key) {
  return key == up_key || key == down_key ||
         std::ranges::any_of(directions, [key](const auto& d) { return key == d.letter || key == d.arrow; });
}

}  // namespace

Fly::Fly(Workbench& bench) : QObject(&bench), bench_(bench), speed_m_s_(walking_m_s) {
  bench_.commands().add(
      {.id = "view.fly",
       .text = tr("Fly through the plot"),
       .key = QKeySequence("Shift+Z"),
       .places = {in_menu(Menu::view, fly_section), in_context("scene")},
       .turn = [this](bool on) { turn(on); },
       .enabled_when = {[this] { return bench_.scene().has_survey(); }, tr("Open a scan or a point cloud first.")},
       .checked_when = [this] { return on_; },
       .tip = tr("W A S D or the arrow keys move, the mouse looks around, the wheel sets the speed; Esc ends"),
       .own_keys = {{tr("ahead, left, back, right"), QStringLiteral("W A S D")},
                    {tr("the same"), QStringLiteral("↑ ← ↓ →")},
                    {tr("up, down"), tr("Page Up, Page Down")},
                    {tr("look around"), tr("move the mouse")},
                    {tr("faster, slower"), tr("wheel")},
                    {tr("end"), tr("Esc, click")}}});
  frame_.setInterval(frame_ms);
  connect(&frame_, &QTimer::timeout, this, &Fly::step);
  connect(&bench_, &Workbench::document_opened, this, [this] { turn(false); });
  connect(&bench_.scene(), &SceneView::place_taker_changed, this, [this](const QObject* taker) {
    if (on_ && taker != this) end();
  });
}

void Fly::turn(bool on) {
  if (on == on_) return;
  on ? begin() : bench_.scene().set_place_taker(nullptr);  // which ends it
}

void Fly::begin() {
  auto& scene = bench_.scene();
  if (scene.flat()) bench_.commands().trigger("view.map");
  if (scene.parallel()) scene.set_parallel(false);
  scene.set_place_taker(this);  // tools that take clicks end
  on_ = true;
  pressed_.clear();
  looked_at_.reset();
  scene.installEventFilter(this);
  scene.setFocus();
  scene.setMouseTracking(true);
  scene.setCursor(Qt::BlankCursor);
  say_keys();
  bench_.commands().update();
}

void Fly::end() {
  on_ = false;
  frame_.stop();
  bench_.scene().removeEventFilter(this);
  bench_.scene().setCursor(Qt::ArrowCursor);
  bench_.hint({});
  bench_.commands().update();
}

void Fly::say_keys() const {
  bench_.hint(tr("W A S D or arrow keys move at %1 m/s, mouse looks, wheel sets the speed, Esc ends.")
                  .arg(speed_m_s_, 0, 'f', 1));
}

bool Fly::eventFilter(QObject*, QEvent* event) {
  auto* key = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease ||
                      event->type() == QEvent::ShortcutOverride
                  ? static_cast<QKeyEvent*>(event)
                  : nullptr;
  switch (event->type()) {
    case QEvent::ShortcutOverride:  // A, D and others are keys of commands too
      if (!moves(key->key()) && key->key() != Qt::Key_Escape) return false;
      event->accept();
      return true;
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
      if (key->key() == Qt::Key_Escape) {
        turn(false);
        return true;
      }
      if (!moves(key->key())) return false;
      press(key, event->type() == QEvent::KeyPress);
      return true;
    case QEvent::MouseMove:
      look(static_cast<QMouseEvent*>(event)->pos());
      return true;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      return true;
    case QEvent::MouseButtonRelease:
      turn(false);
      return true;
    case QEvent::Wheel:
      change_speed(static_cast<QWheelEvent*>(event)->angleDelta().y() / 120.0);
      return true;
    case QEvent::FocusOut:
      if (static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason) turn(false);
      return false;
    default:
      return false;
  }
}

void Fly::press(QKeyEvent* event, bool down) {
  if (event->isAutoRepeat()) return;
  down ? static_cast<void>(pressed_.insert(event->key())) : static_cast<void>(pressed_.remove(event->key()));
  if (pressed_.isEmpty()) return frame_.stop();
  if (frame_.isActive()) return;
  clock_.start();
  frame_.start();
}

// The cursor goes back to the middle before it leaves the view.
void Fly::look(const QPoint& at) {
  auto& scene = bench_.scene();
  if (looked_at_) {
    const QPoint by = at - *looked_at_;
    if (!by.isNull()) scene.fly(Eigen::Vector3d::Zero(), by.x() * rad_per_px, -by.y() * rad_per_px);
  }
  looked_at_ = at;
  const QRect inner =
      scene.rect().adjusted(scene.width() / 4, scene.height() / 4, -scene.width() / 4, -scene.height() / 4);
  if (inner.contains(at)) return;
  looked_at_ = scene.rect().center();
  QCursor::setPos(scene.mapToGlobal(*looked_at_));
}

void Fly::change_speed(double notches) {
  speed_m_s_ = std::clamp(speed_m_s_ * std::pow(speed_per_notch, notches), min_m_s, max_m_s);
  say_keys();
}

void Fly::step() {
  const double metres = speed_m_s_ * 1e-3 * static_cast<double>(std::min<qint64>(clock_.restart(), longest_step_ms));
  Eigen::Vector3d by = Eigen::Vector3d::Zero();  // right, up, ahead
  for (const auto& d : directions)
    if (pressed_.contains(d.letter) || pressed_.contains(d.arrow)) by += Eigen::Vector3d(d.right, 0, d.ahead);
  if (pressed_.contains(up_key)) by.y() += 1;
  if (pressed_.contains(down_key)) by.y() -= 1;
  if (by.norm() > 0) bench_.scene().fly(metres * by.normalized(), 0, 0);
}

}  // namespace bole::desktop
