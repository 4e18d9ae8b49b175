// A chart of the survey whose points and bars are trees: a click selects, the selected tree is marked.
#pragma once

#include <QWidget>

#include "document/selection.h"
#include "document/survey.h"
#include "render/charts/linked_charts.h"

class QComboBox;

namespace bole::desktop {

class ChartView : public QWidget {
  Q_OBJECT

 public:
  ChartView(Selection& selection, QWidget* parent);
  void show_survey(const Survey& survey);
  void show_chart(const QString& id);         // one of linked_charts()
  QPointF place_of(std::int64_t tree) const;  // on the widget; null when it is not in the chart
  QSize sizeHint() const override { return {340, 260}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  void rebuild();
  QRect sheet() const;  // below the list of charts

  Selection& selection_;
  Survey survey_;
  render::LinkedChart chart_;
  QComboBox* charts_;
};

}  // namespace bole::desktop
