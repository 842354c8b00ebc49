// SPDX-License-Identifier: MIT-0
/// @file
/// The tables of a collection, which a course reads.
#pragma once
#include <filesystem>
#include <functional>

#include "hosts/haul.h"

namespace grade {

/// Seconds on UTC's clocks, as such a table has them.
std::string as_written(Instant time);

/// @throws Usage  a table that is there is another one
void check_are_ours(const std::filesystem::path& times, const std::filesystem::path& people);

/// Says when each file was handed in, by the folder of its student. Lines of students who are not
/// in this haul stay. A file of which nobody knows the time has an empty cell, which a course asks
/// to fill in; what was filled in stays as long as the file is the same.
/// @param same  whether this file has been there with these bytes
/// @returns how many times the table lacks
/// @throws Usage  the table that is there is another one
std::size_t write_times(const Haul& haul, const std::filesystem::path& table,
                        const std::function<bool(const HandedFile&)>& same);

/// Says whose the folders are, as far as the system did: in a table by which a course finds the
/// student that its roster calls otherwise.
void write_people(const Haul& haul, const std::filesystem::path& table);

/// Reads it back; nobody if there is none.
/// @throws Usage  it is another one
std::map<std::string, Person> people_in(const std::filesystem::path& table);

}  // namespace grade
