#pragma once

#include <cstddef>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace mote
{

/// Calls visit(std::type_identity<T>()) with the alternative T of a closed variant that has this
/// index. The calls for all alternatives answer the same type.
template <typename Variant, std::size_t FROM = 0, typename Visit>
auto withAlternative(std::size_t index, const Visit& visit)
{
  if constexpr (FROM + 1 < std::variant_size_v<Variant>)
    if (index != FROM)
      return withAlternative<Variant, FROM + 1>(index, visit);
  return visit(std::type_identity<std::variant_alternative_t<FROM, Variant>>());
}

/// name() of every alternative, in their order.
template <typename Variant>
std::vector<std::string> alternativeNames()
{
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::variant_size_v<Variant>; ++i)
    names.push_back(withAlternative<Variant>(
      i, []<typename T>(std::type_identity<T>) { return std::string(T::name()); }));
  return names;
}

} // namespace mote
