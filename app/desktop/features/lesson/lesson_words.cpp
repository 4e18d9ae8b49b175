#include "features/lesson/lesson_words.h"

#include <QCoreApplication>

namespace bole::desktop {

QString lesson_text(const std::string& english) {
  return english.empty() ? QString() : QCoreApplication::translate(lesson_context, english.c_str());
}

std::vector<std::string> lesson_texts(const Lesson& lesson) {
  std::vector<std::string> texts{lesson.title};
  const auto add = [&](const std::string& text) {
    if (!text.empty()) texts.push_back(text);
  };
  for (const auto& sentence : lesson.learn) add(sentence);
  for (const auto& step : lesson.steps) {
    add(step.title);
    for (const auto& paragraph : step.text) add(paragraph);
    for (const auto& sight : step.see) add(sight.text);
    for (const auto& question : step.questions) {
      add(question.ask);
      add(question.why);
      add(question.hint);
      for (const auto& choice : question.choices) {
        add(choice.text);
        add(choice.why);
      }
    }
  }
  return texts;
}

}  // namespace bole::desktop
