// A form made from the option table of a stage: label, unit, range, tooltip and tier come from the declaration.
#pragma once

#include <QWidget>

#include "document/session.h"

class QCheckBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace bole::desktop {

class PropertiesPanel : public QWidget {
  Q_OBJECT

 public:
  PropertiesPanel(Session& session, QWidget* parent);

 public Q_SLOTS:
  void show_stage(const QString& id);

 Q_SIGNALS:
  void refused(const QString& sentence);  // an option refused a value

 private:
  void rebuild();
  QWidget* editor_for(const StageNode& node, const OptionSpec& spec);
  void commit(const std::string& option, const OptionValue& value);

  Session& session_;
  QString stage_;
  QLabel* title_;
  QLineEdit* search_;
  QCheckBox* advanced_;
  QVBoxLayout* layout_;
  QWidget* form_ = nullptr;
};

}  // namespace bole::desktop
