#include "stems/core/fit/stem_reasons.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <array>

namespace bole::stems {
namespace {

constexpr std::array<std::string_view, 27> reason_formats{
    "only {:.0f} deg of the bark seen",
    "{:.0f} deg of the bark seen and no sensor positions: the diameter may be biased",
    "wide interval: +-{:.1f} cm",
    "few points: {:.0f} on the bark, {:.0f} in each section",
    "breast height hidden: extrapolated from {:.1f} to {:.1f} m",
    "breast height hidden: interpolated between {:.1f} and {:.1f} m",
    "only {:.0f} sections",
    "{:.0f} % of the points lie inside",
    "on {:.0f} deg of the bark the points lie inside the circle",
    "the bark hardly stands out: {:.1f} times as dense as beside it",
    "rough or blurred bark: {:.1f} cm",
    "passes disagree by {:.0f} cm",
    "wider above than below",
    "{:.0f} % of the rays pass through",
    "leans {:.0f} deg",
    "forks at about {:.1f} m: counted once",
    "goes on {:.1f} m below the terrain: the ground is wrong here, {:.1f} m is not breast height",
    "begins {:.1f} m above a terrain that was not seen here: breast height is uncertain",
    "no ground seen within {:.0f} m: the terrain is interpolated here",
    "begins at the lowest points of the cloud and does not widen there: its foot may be missing",
    "ends {:.1f} m above ground: a stump, a post, a person?",
    "added by hand",
    "added by hand, circle fitted to the slice",
    "split from {:.0f} by hand",
    "not round: points scatter by {:.1f} cm, more than on other stems: a tape may read {:.1f} cm more",
    "seen on {:.0f} deg and fitted as narrowing by {:.1f} cm per metre, as stems seldom do: taper and diameter may be "
    "mistaken for one another",
    "narrows by {:.1f} cm per metre at breast height: a root flare, a buttress, or a bank that stands above the "
    "terrain"};
static_assert(reason_formats.size() == static_cast<std::size_t>(StemReason::flares) + 1);

}  // namespace

Reason::Reason(StemReason why, std::initializer_list<double> numbers) {
  fmt::dynamic_format_arg_store<fmt::format_context> store;
  for (const double n : numbers) store.push_back(n);
  text_ = fmt::vformat(reason_formats[static_cast<std::size_t>(why)], store);
}

std::span<const std::string_view> stem_reason_formats() { return reason_formats; }

std::string joined(const std::vector<Reason>& reasons) {
  std::string all;
  for (const auto& reason : reasons) all += (all.empty() ? "" : "; ") + reason.text();
  return all;
}

}  // namespace bole::stems
