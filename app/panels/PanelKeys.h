#pragma once

struct ImGuiIO;

namespace mote::app
{

/// Tells ImGui which of the places below are the keys that it asks for by meaning.
void mapKeys(ImGuiIO& io);

/// The place of a key of X11's name among ImGui's keys that are down; -1 for those it never asks
/// for.
int placeOfKey(const char* symbol);

/// Whether a key moves between controls or works one that has no text.
bool isForMoving(const char* symbol);

} // namespace mote::app
