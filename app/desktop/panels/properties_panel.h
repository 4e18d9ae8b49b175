// A form made from the option table of a stage: label, unit, range, tooltip and tier come from the declaration. Changes
// go into the document as they are made, or wait for Apply.
#pragma once

#include <QWidget>
#include <map>
#include <string>
#include <vector>

#include "document/session.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLayout;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace bole::desktop {

class PropertiesPanel : public QWidget {
  Q_OBJECT

 public:
  PropertiesPanel(Session& session, QWidget* parent);

 public Q_SLOTS:
  void show_stage(const QString& id);
  void set_tier(Tier tier);
  void apply();  // what waits, when changes are not taken at once
  void restore_defaults();

 Q_SIGNALS:
  void refused(const QString& sentence);  // an option refused a value

 private:
  QLayout* buttons_layout();
  void connect_widgets();
  void rebuild();
  void show_notice(const pipeline::StageNode& stage);
  void show_pending();
  void show_conditions();
  const pipeline::StageNode* node() const;  // null when there is none
  bool is_listed(const pipeline::StageType& type, const OptionSpec& spec) const;
  OptionValue value_of(const pipeline::StageNode& stage, const OptionSpec& spec) const;  // with what waits
  QWidget* editor_for(const OptionValue& value, const OptionSpec& spec);
  void commit(const std::string& option, const OptionValue& value);

  Session& session_;
  QString stage_;
  std::map<std::string, OptionValue> pending_;
  QLabel* title_;
  QLineEdit* search_;
  QComboBox* tier_;
  QLabel* notice_;
  QCheckBox* at_once_;
  QPushButton *apply_, *reset_, *defaults_;
  QVBoxLayout* layout_;
  QWidget* form_ = nullptr;
  struct Row {
    const OptionSpec* spec;
    QLabel* name;
    QWidget* editor;
    QString help;
  };
  std::vector<Row> rows_;  // of the form
};

}  // namespace bole::desktop
