#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

/// Several small files as one: before each stand `packMark`, its name with folders, and a line end.
constexpr std::string_view packMark = "\x1e\x1f\x1e\x1f";

/// All files below a folder, as one.
std::string packed(const std::filesystem::path& folder);

/// Writes the files of a pack into a folder. Those whose names lead elsewhere, or are none, are
/// left out, and so are more than 40.
void unpack(std::string_view pack, const std::filesystem::path& folder);
