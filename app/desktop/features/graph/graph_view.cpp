#include "features/graph/graph_view.h"

#include <QApplication>
#include <QBuffer>
#include <QFileInfo>
#include <QHelpEvent>
#include <QImage>
#include <QKeyEvent>
#include <QPainter>
#include <QStyle>
#include <QTextDocument>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/atomic_file.h"
#include "base/error.h"
#include "look/svg_paper.h"
#include "panels/pipeline_panel.h"
#include "running/stage_states.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

// In heights of a line of text.
constexpr double layer_gap = 2.6, box_gap = 1.1, lane_gap = 0.9, paper_margin = 1;
constexpr double max_fit_scale = 1.2, max_scale = 4, min_scale = 0.05, graph_wheel_step = 1.0015;
constexpr int picture_px = 3840;  // of the longer side: two pixels for each of a slide
constexpr int max_tips = 5;

std::size_t index_of(Qt::Orientation orientation) { return orientation == Qt::Horizontal ? 0 : 1; }

QString words_of(const StageState& state, const QStringList& missing) {
  if (!missing.isEmpty()) return GraphView::tr("needs %1").arg(missing.join(", "));
  if (state.kind == StageState::Kind::not_run) return GraphView::tr("not run");
  if (state.kind == StageState::Kind::running)
    return state_words(state) + QString(" · %1 %").arg(std::lround(100 * state.fraction));
  return state.seconds ? state_words(state) + " · " + seconds_words(*state.seconds) : state_words(state);
}

bool is_arrow_key(int key) {
  return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

bool is_enter(int key) { return key == Qt::Key_Return || key == Qt::Key_Enter; }

}  // namespace

GraphView::GraphView(Workbench& bench) : QGraphicsView(&bench), bench_(bench), ink_(std::make_shared<GraphInk>()) {
  setObjectName("graph_view");
  setAccessibleName(tr("Pipeline graph"));
  setScene(new QGraphicsScene(this));
  scene()->setItemIndexMethod(QGraphicsScene::NoIndex);
  setDragMode(ScrollHandDrag);
  setTransformationAnchor(AnchorUnderMouse);
  setFrameShape(NoFrame);
  connect(&bench_.session(), &Session::document_replaced, this, &GraphView::rebuild);
  connect(&bench_, &Workbench::document_opened, this, &GraphView::fit);
  connect(&bench_.stage_states(), &StageStates::changed, this, &GraphView::show_states);
  connect(&bench_.stage_states(), &StageStates::stage_changed, this, [this](const QString& id) {
    if (auto* changed = box(id)) show_state(*changed);
  });
  connect(&bench_.pipeline(), &PipelinePanel::stage_selected, this, &GraphView::show_current);
  lay_out();
}

QSize GraphView::sizeHint() const { return (QSizeF(40, 14) * ink_->line()).toSize(); }

QSize GraphView::minimumSizeHint() const { return (QSizeF(10, 4) * ink_->line()).toSize(); }

void GraphView::rebuild() {
  graph_ = StageGraph::of(bench_.session().document());
  lay_out();
}

void GraphView::lay_out() {
  ink_->font = font();
  ink_->font.setHintingPreference(QFont::PreferNoHinting);  // it is seen at any scale
  ink_->palette = palette();
  std::vector<GraphArrow> ends;
  for (const auto& join : graph_.joins) ends.push_back({join.from, join.to});
  const double line = ink_->line();
  for (const auto orientation : {Qt::Horizontal, Qt::Vertical})
    layouts_[index_of(orientation)] = lay_out_graph(graph_.stages.size(), ends, ink_->box(),
                                                    {layer_gap * line, box_gap * line, lane_gap * line}, orientation);
  show_layout(whole_ ? larger() : orientation_);
  if (whole_) fit();
}

void GraphView::show_layout(Qt::Orientation orientation) {
  orientation_ = ink_->orientation = orientation;
  scene()->clear();
  boxes_.clear();
  arrows_.clear();
  const auto& places = layout();
  for (std::size_t j = 0; j < graph_.joins.size(); ++j) {
    arrows_.push_back(new StageArrow(graph_.joins[j].from, graph_.joins[j].to, places.arrows[j], orientation, ink_));
    scene()->addItem(arrows_.back());
  }
  for (std::size_t s = 0; s < graph_.stages.size(); ++s) {
    boxes_.push_back(new StageBox(graph_.stages[s].id, ink_));
    boxes_.back()->setPos(places.boxes[s].topLeft());
    scene()->addItem(boxes_.back());
  }
  const double margin = paper_margin * ink_->line();
  scene()->setSceneRect(places.extent.adjusted(-margin, -margin, margin, margin));
  show_states();
  show_current();
}

double GraphView::scale_for(Qt::Orientation orientation) const {
  const double margin = 2 * paper_margin * ink_->line();
  const QSizeF needed = layouts_[index_of(orientation)].extent.size() + QSizeF(margin, margin);
  const QSizeF room = maximumViewportSize() - QSize(2, 2);  // a rounded pixel more would bring scroll bars
  return std::clamp(std::min(room.width() / needed.width(), room.height() / needed.height()), min_scale, max_fit_scale);
}

Qt::Orientation GraphView::larger() const {
  return scale_for(Qt::Horizontal) >= scale_for(Qt::Vertical) ? Qt::Horizontal : Qt::Vertical;
}

void GraphView::fit() {
  whole_ = true;
  if (larger() != orientation_) show_layout(larger());
  const double scale = scale_for(orientation_);
  setTransform(QTransform::fromScale(scale, scale));
  centerOn(sceneRect().center());
}

void GraphView::show_state(StageBox& box) const {
  const auto stage = std::ranges::find(graph_.stages, box.stage(), &StageGraph::Stage::id);
  const auto state = bench_.stage_states().of(box.stage().toStdString());
  StageBox::Look look;
  look.title = stage->title;
  look.state = words_of(state, stage->missing);
  look.missing = stage->missing;
  look.mark = mark_of(state.kind);
  look.warnings = state.kind == StageState::Kind::warnings ? static_cast<int>(state.warnings.size()) : 0;
  look.fraction = state.fraction;
  look.stale = state.kind == StageState::Kind::out_of_date || state.kind == StageState::Kind::skipped;
  box.set_look(look);
}

void GraphView::show_states() const {
  for (auto* box : boxes_) show_state(*box);
}

void GraphView::show_current() {
  const QString id = bench_.pipeline().current_stage();
  for (auto* box : boxes_) {
    box->set_current(box->stage() == id);
    if (box->current() && !whole_) box->ensureVisible();
  }
  for (auto* arrow : arrows_) arrow->set_lit(boxes_[arrow->from()]->current() || boxes_[arrow->to()]->current());
}

void GraphView::choose(const StageBox* box) {
  if (box != nullptr) bench_.pipeline().select_stage(box->stage());
}

StageBox* GraphView::box(const QString& id) const {
  const auto it = std::ranges::find_if(boxes_, [&](const auto* box) { return box->stage() == id; });
  return it == boxes_.end() ? nullptr : *it;
}

StageBox* GraphView::box_at(const QPointF& place) const {
  const auto it = std::ranges::find_if(boxes_, [&](const auto* box) {
    return box->sceneBoundingRect().contains(place) && box->frame().contains(box->mapFromScene(place));
  });
  return it == boxes_.end() ? nullptr : *it;
}

// Along the arrows to the nearest layer, and there to the nearest box; across them within the layer. Where nothing is
// joined: to the nearest box on that side.
StageBox* GraphView::next_box(int key) const {
  const auto from = std::ranges::find_if(boxes_, [](const auto* box) { return box->current(); });
  if (from == boxes_.end()) return boxes_.empty() ? nullptr : boxes_.front();
  const auto here = static_cast<std::size_t>(from - boxes_.begin());
  const bool wide = orientation_ == Qt::Horizontal;
  const bool along = wide == (key == Qt::Key_Left || key == Qt::Key_Right);
  const bool on = key == Qt::Key_Right || key == Qt::Key_Down;
  const auto& places = layout();
  const auto across = [&](std::size_t b) {
    const QPointF middle = places.boxes[b].center();
    return wide ? middle.y() : middle.x();
  };
  using Rank = std::tuple<bool, int, double>;
  std::optional<std::pair<Rank, std::size_t>> best;
  for (std::size_t b = 0; b < boxes_.size(); ++b) {
    const int layers = places.layers[b] - places.layers[here];
    const double aside = across(b) - across(here);
    if (b == here || (along ? (on ? layers <= 0 : layers >= 0) : layers != 0 || (on ? aside <= 0 : aside >= 0)))
      continue;
    const bool joined = std::ranges::any_of(
        graph_.joins, [&](const auto& j) { return on ? j.from == here && j.to == b : j.from == b && j.to == here; });
    const Rank rank{along && !joined, std::abs(layers), std::abs(aside)};
    if (!best || rank < best->first) best = {rank, b};
  }
  return best ? boxes_[best->second] : nullptr;
}

QString GraphView::tip_of(const StageBox& box) const {
  const auto stage = std::ranges::find(graph_.stages, box.stage(), &StageGraph::Stage::id);
  QStringList lines{stage->title, stage->description};
  for (const auto& port : stage->missing) lines << tr("The required input %1 is not connected.").arg(port);
  if (!stage->missing.isEmpty()) return lines.join('\n');  // what else keeps it from running follows from that
  const auto state = bench_.stage_states().of(box.stage().toStdString());
  lines << words_of(state, {}) << state_details(state);
  lines.removeAll({});
  return lines.join('\n');
}

// Arrows of one stage share a part of their way: there all of them are told.
QString GraphView::tip_at(const QPointF& place) const {
  if (const auto* box = box_at(place)) return tip_of(*box);
  QStringList texts;
  for (std::size_t a = 0; a < arrows_.size(); ++a)
    if (arrows_[a]->shape().contains(place)) texts << graph_.words(graph_.joins[a], bench_.runner().results());
  if (texts.size() > max_tips) texts = texts.mid(0, max_tips) << QStringLiteral("…");
  return texts.join("\n\n");
}

bool GraphView::viewportEvent(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QGraphicsView::viewportEvent(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const QString tip = tip_at(mapToScene(help->pos()));
  const QString wrapped = tip.isEmpty() ? tip : Qt::convertFromPlainText(tip, Qt::WhiteSpaceNormal);
  QToolTip::showText(help->globalPos(), wrapped, viewport());
  return true;
}

// The keys of the graph are not those of the window while it has the focus.
bool GraphView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool plain = !(key->modifiers() & ~Qt::KeypadModifier);
    if (plain && (is_arrow_key(key->key()) || is_enter(key->key()))) event->accept();
  }
  return QGraphicsView::event(event);
}

void GraphView::keyPressEvent(QKeyEvent* event) {
  if (is_arrow_key(event->key())) return choose(next_box(event->key()));
  if (is_enter(event->key())) return Q_EMIT options_asked();
  QGraphicsView::keyPressEvent(event);
}

void GraphView::mousePressEvent(QMouseEvent* event) {
  choose(box_at(mapToScene(event->pos())));
  QGraphicsView::mousePressEvent(event);
}

void GraphView::mouseDoubleClickEvent(QMouseEvent*) { fit(); }

void GraphView::contextMenuEvent(QContextMenuEvent* event) {
  if (event->reason() == QContextMenuEvent::Mouse) choose(box_at(mapToScene(event->pos())));
  Q_EMIT menu_asked(event->globalPos());
}

void GraphView::wheelEvent(QWheelEvent* event) {
  whole_ = false;
  const double now = transform().m11();
  const double then = std::clamp(now * std::pow(graph_wheel_step, event->angleDelta().y()), min_scale, max_scale);
  scale(then / now, then / now);
}

void GraphView::resizeEvent(QResizeEvent* event) {
  QGraphicsView::resizeEvent(event);
  if (whole_) fit();
}

void GraphView::changeEvent(QEvent* event) {
  QGraphicsView::changeEvent(event);
  if (event->type() == QEvent::FontChange) return lay_out();
  if (event->type() != QEvent::PaletteChange) return;
  ink_->palette = palette();
  scene()->update();
}

void GraphView::focusInEvent(QFocusEvent* event) {
  QGraphicsView::focusInEvent(event);
  show_focus(true);
}

void GraphView::focusOutEvent(QFocusEvent* event) {
  QGraphicsView::focusOutEvent(event);
  show_focus(false);
}

void GraphView::show_focus(bool on) {
  ink_->focus = on;
  for (auto* box : boxes_) box->update();
}

void GraphView::save(const QString& path) const {
  const GraphInk kept = *ink_;
  ink_->palette = QApplication::style()->standardPalette();
  ink_->palette.setColor(QPalette::Base, Qt::white);
  ink_->choice = false;
  const QSizeF size = sceneRect().size();
  const auto draw = [&](QPaintDevice& paper, double scale) {
    QPainter painter(&paper);
    painter.fillRect(QRectF(QPointF(), size * scale), Qt::white);
    scene()->render(&painter, QRectF(QPointF(), size * scale), sceneRect());
  };
  QByteArray bytes;
  if (QFileInfo(path).suffix().toLower() == "svg") {
    SvgPaper paper(size.toSize());
    draw(paper, 1);
    bytes = paper.svg();
  } else {
    const double scale = picture_px / std::max(size.width(), size.height());
    QImage image((size * scale).toSize(), QImage::Format_RGB32);
    draw(image, scale);
    QBuffer buffer(&bytes);
    image.save(&buffer, "PNG");
  }
  *ink_ = kept;
  write_text_file(path.toStdString(), std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

}  // namespace bole::desktop
