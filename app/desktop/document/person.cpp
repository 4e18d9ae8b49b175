#include "document/person.h"

#include <QProcessEnvironment>

namespace bole::desktop {

QString person() {
  const auto env = QProcessEnvironment::systemEnvironment();
  return env.value("BOLE_AUTHOR", env.value("USER"));
}

}  // namespace bole::desktop
