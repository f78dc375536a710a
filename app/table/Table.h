#pragma once

#include "Row.h"

namespace mote::app
{

// The rows of each group, a file each; settingsTable() puts them together.
void addDataRows(std::vector<Row>& table);
void addColorRows(std::vector<Row>& table);
void addSelectionRows(std::vector<Row>& table);
void addCutRows(std::vector<Row>& table);
void addParticleRows(std::vector<Row>& table);
void addVolumeRows(std::vector<Row>& table);
void addSliceRows(std::vector<Row>& table);
void addFlowRows(std::vector<Row>& table);
void addCameraRows(std::vector<Row>& table);
void addLightRows(std::vector<Row>& table);
void addSilhouetteRows(std::vector<Row>& table);
void addMarkRows(std::vector<Row>& table);
void addPictureRows(std::vector<Row>& table);

// What commands alone take, in files of its own: what commandTable() puts beside the rest.
void addTimeRows(std::vector<Row>& table);
void addPlotRows(std::vector<Row>& table);
void addFilmRows(std::vector<Row>& table);
void addRecordingRows(std::vector<Row>& table);
void addMeasureRows(std::vector<Row>& table);

/// The row of what a command writes.
Row outputRow(const std::string& command, const std::string& help, bool required);

/// The row of --all-steps.
Row allStepsRow(const std::string& command, const std::string& help);

/// A check that says in a sentence what is wrong with a text, as one that throws WrongValue.
std::function<void(const std::string&)> refusing(std::string (*check)(const std::string&));

} // namespace mote::app
