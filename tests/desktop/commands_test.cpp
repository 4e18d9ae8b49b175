// The registry of commands, and what the window makes of it.
#include "commands/commands.h"

#include <QMainWindow>
#include <QMenu>
#include <QTest>
#include <QToolBar>

#include "base/error.h"
#include "shell/main_window.h"
#include "shell_test.h"

namespace bole::desktop {
namespace {

QStringList texts(const QMenu& menu) {
  QStringList list;
  for (const auto* action : menu.actions()) list << (action->isSeparator() ? QString("-") : action->text());
  return list;
}

std::string error_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& e) {
    return e.what();
  }
  return {};
}

}  // namespace

class CommandsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void an_id_is_taken_once() {
    commands_->add({.id = "a"});
    const auto said = error_of([&] { commands_->add({.id = "a"}); });
    QVERIFY2(said.find("'a'") != std::string::npos, said.c_str());
    QVERIFY(
        !error_of([&] { commands_->add_submenu({.id = "a", .title = "A", .place = in_menu(Menu::file)}); }).empty());
    QCOMPARE(commands_->entries().size(), std::size_t{1});
  }

  void a_key_is_taken_once_in_a_context() {
    QWidget one, other;
    commands_->add({.id = "window", .key = Qt::Key_F2});
    const auto said = error_of([&] { commands_->add({.id = "again", .key = Qt::Key_F2}); });
    QVERIFY2(said.find("'window'") != std::string::npos && said.find("F2") != std::string::npos, said.c_str());
    // In a part of the window the key would mean two things as well.
    QVERIFY(!error_of([&] { commands_->add({.id = "part", .key = Qt::Key_F2, .owner = &one}); }).empty());
    commands_->add({.id = "one", .key = Qt::Key_F3, .owner = &one});
    commands_->add({.id = "other", .key = Qt::Key_F3, .owner = &other});
    QVERIFY(!error_of([&] { commands_->add({.id = "one more", .key = Qt::Key_F3, .owner = &one}); }).empty());
    commands_->add({.id = "no key"});
    commands_->add({.id = "no key either"});
  }

  void a_menu_has_its_sections_in_order() {
    commands_->add({.id = "last", .text = "Last", .places = {in_menu(Menu::view, 5)}});
    commands_->add({.id = "first", .text = "First", .places = {in_menu(Menu::view), in_context("stem")}});
    commands_->add_submenu({.id = "more", .title = "More", .place = in_menu(Menu::view)});
    commands_->add({.id = "below", .text = "Below", .places = {in_submenu("more")}});
    commands_->add({.id = "second", .text = "Second", .places = {in_menu(Menu::view)}});
    QMenu menu, context;
    commands_->fill(menu, in_menu(Menu::view));
    QCOMPARE(texts(menu), (QStringList{"First", "More", "Second", "-", "Last"}));
    QCOMPARE(texts(*menu.actions()[1]->menu()), QStringList{"Below"});
    commands_->fill(context, in_context("stem"));
    QCOMPARE(texts(context), QStringList{"First"});
  }

  void a_submenu_follows_what_it_lists() {
    QStringList files;
    commands_->add_submenu({.id = "recent", .title = "Recent", .place = in_menu(Menu::file), .fill = [&](QMenu& menu) {
                              for (const auto& file : files) menu.addAction(file);
                            }});
    QMenu menu;
    commands_->fill(menu, in_menu(Menu::file));
    auto* recent = menu.actions().front()->menu();
    QVERIFY(!recent->isEnabled());
    files << "a.json"
          << "b.json";
    Q_EMIT menu.aboutToShow();
    QVERIFY(recent->isEnabled());
    QCOMPARE(texts(*recent), files);
  }

  void a_disabled_command_tells_what_it_needs() {
    bool open = false;
    int runs = 0;
    auto* action = commands_->add({.id = "run",
                                   .act = [&] { ++runs; },
                                   .enabled_when = {[&] { return open; }, "Open a scan first."},
                                   .tip = "Runs all stages"});
    commands_->update();
    const auto said = error_of([&] { commands_->trigger("run"); });
    QVERIFY2(said.find("Open a scan first.") != std::string::npos, said.c_str());
    open = true;
    commands_->update();
    commands_->trigger("run");
    QCOMPARE(runs, 1);
    QCOMPARE(action->toolTip(), QString("Runs all stages"));
    QVERIFY(!error_of([&] { commands_->trigger("fly"); }).empty());
  }

  void a_switch_shows_its_state() {
    int theme = 0;
    bool refuses = true;
    for (const int k : {0, 1})
      commands_->add({.id = QString::number(k),
                      .turn =
                          [&, k](bool) {
                            if (!refuses) theme = k;
                          },
                      .checked_when = [&, k] { return theme == k; },
                      .group = "theme"});
    commands_->update();
    commands_->trigger("1");
    QVERIFY(commands_->action("0")->isChecked() && !commands_->action("1")->isChecked());
    refuses = false;
    commands_->trigger("1");
    QVERIFY(!commands_->action("0")->isChecked() && commands_->action("1")->isChecked());
  }

  void errors_of_commands_are_caught() {
    commands_->add({.id = "fail", .act = [] { throw failure("the disk is full"); }});
    commands_->trigger("fail");
    QCOMPARE(caught_, QStringList{"the disk is full"});
  }

  // Whatever has a key or stands in a menu of the window is a command.
  void the_window_has_no_other_keys() {
    MainWindow window;
    QSet<const QAction*> registered;
    for (const auto& entry : window.commands().entries()) registered << entry->action;
    for (const auto* action : window.findChildren<QAction*>())
      if (!action->shortcut().isEmpty()) QVERIFY2(registered.contains(action), qPrintable(action->text()));
    QCOMPARE(window.findChildren<QToolBar*>().front()->actions().front(), window.commands().action("run.all"));
  }

  void every_command_can_be_reached() {
    MainWindow window;
    for (const auto& entry : window.commands().entries()) {
      QVERIFY2(!entry->command.places.empty(), qPrintable(entry->command.id));
      QVERIFY2(entry->submenu || !entry->action->text().isEmpty(), qPrintable(entry->command.id));
    }
  }

  void commands_wait_for_what_they_need() {
    MainWindow window;
    for (const char* id : {"document.save", "run.all", "run.cancel", "stem.accept", "row.delete", "figure.export"}) {
      QVERIFY2(!window.commands().action(id)->isEnabled(), id);
      QVERIFY2(window.commands().action(id)->toolTip().endsWith('.'), id);
    }
    window.selection().select(7);
    QVERIFY(window.commands().action("stem.accept")->isEnabled());
    window.selection().select({});
    QVERIFY(!window.commands().action("stem.accept")->isEnabled());
  }

  void init() {
    window_ = std::make_unique<QMainWindow>();
    commands_ = new Commands(*window_, [this](const auto& act) {
      try {
        act();
      } catch (const Error& e) {
        caught_ << e.what();
      }
    });
    caught_.clear();
  }

 private:
  std::unique_ptr<QMainWindow> window_;
  Commands* commands_ = nullptr;
  QStringList caught_;
};

int run_commands_test(int argc, char** argv) {
  CommandsTest test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace bole::desktop
#include "commands_test.moc"
