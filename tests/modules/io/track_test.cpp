#include "io/core/tables/track_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "base/error.h"
#include "io/core/tables/nmea_reader.h"
#include "io_test_tools.h"
#include "real_data.h"

namespace bole::io {
namespace {

using ::testing::HasSubstr;
using testing_io::bytes_of;

std::string sentence(const std::string& body) {
  unsigned sum = 0;
  for (const char c : body) sum ^= static_cast<unsigned char>(c);
  char tail[8];
  std::snprintf(tail, sizeof tail, "*%02X\r\n", sum);
  return "$" + body + tail;
}

const std::string gga = sentence("GNGGA,080150.50,2308.88200,N,11321.30000,E,4,17,0.7,30.250,M,-5.250,M,1.0,0133");

TEST(Nmea, SentencesOfAnEpochMakeOneRow) {
  const auto text = gga + sentence("GNRMC,080150.50,A,2308.88200,N,11321.30000,E,1.6,91.5,180320,,,R") +
                    sentence("GNGST,080150.50,0.01,,,,0.011,0.012,0.025") + sentence("GNHDT,90.25,T") +
                    sentence("GNVTG,92.0,T,,M,1.6,N,3.0,K,R") +
                    sentence("GNGGA,080150.60,2308.88200,S,11321.30000,W,5,17,0.7,30.250,M,,M,,");
  const auto log = read_nmea(bytes_of(text));
  ASSERT_EQ(log.track.rows(), 2U);
  const auto value = [&](const char* name, std::size_t row = 0) { return log.track.numbers(name)[row]; };
  EXPECT_NEAR(value("time_s"), 8 * 3600 + 60 + 50.5, 1e-9);
  EXPECT_NEAR(value("latitude_deg"), 23 + 8.882 / 60, 1e-12);
  EXPECT_NEAR(value("longitude_deg"), 113 + 21.3 / 60, 1e-12);
  EXPECT_NEAR(value("height_m"), 25.0, 1e-9);
  EXPECT_EQ(value("quality"), 4);
  EXPECT_NEAR(value("heading_deg"), 90.25, 1e-12);
  EXPECT_NEAR(value("speed_m_s"), 3.0 / 3.6, 1e-12);
  EXPECT_NEAR(value("course_deg"), 92.0, 1e-12);
  EXPECT_NEAR(value("sd_north_m"), 0.011, 1e-12);
  EXPECT_NEAR(value("latitude_deg", 1), -value("latitude_deg"), 1e-12);
  EXPECT_NEAR(value("longitude_deg", 1), -value("longitude_deg"), 1e-12);
  EXPECT_TRUE(std::isnan(value("heading_deg", 1)));
}

TEST(Nmea, TimesGoOnPastMidnightAndCarryTheDateWhereItComesFirst) {
  const auto at = [](const char* time) {
    return sentence(std::string("GPGGA,") + time + ",2308.88200,N,11321.30000,E,1,9,1.0,30,M,,M,,");
  };
  const auto log = read_nmea(bytes_of(at("235959.50") + at("000000.00")));
  EXPECT_NEAR(log.track.numbers("time_s")[1] - log.track.numbers("time_s")[0], 0.5, 1e-9);
  const auto modern = read_nmea(bytes_of(sentence("GPRMC,000000.00,V,,,,,,,180320,,,N") + at("000001.00")));
  EXPECT_NEAR(modern.track.numbers("time_s")[0], 1584489601.0, 1e-6);  // 2020-03-18 00:00:01 UTC
}

TEST(Nmea, WhatIsBadIsCountedAndPassedOver) {
  std::string broken = gga;
  broken[20] = '9';
  std::string binary("\xB5\x62\x01\x07$\x00\xFF$G", 9);
  const auto text = "# a comment\n" + broken + binary + gga.substr(0, gga.find('*')) + "\r\n" +
                    sentence("GPGGA,0801xx.00,2308.88,N,11321.3,E,1,9,1,3,M,,M,,") +
                    sentence("GPGGA,080151.00,9908.88,N,11321.3,E,1,9,1,3,M,,M,,") +
                    sentence("GPGGA,080151.00,,,,,0,00,,,M,,M,,") + gga + sentence("GPGGA");
  const auto log = read_nmea(bytes_of(text));
  EXPECT_EQ(log.counts.bad_checksum, 1);
  EXPECT_EQ(log.counts.without_checksum, 1);
  EXPECT_EQ(log.counts.malformed, 2);
  EXPECT_EQ(log.counts.without_fix, 2);
  EXPECT_GT(log.counts.other_bytes, 15);
  EXPECT_EQ(log.track.rows(), 1U);
}

// One receiver may speak as GN and as GP; two receivers in one log do not agree.
TEST(Nmea, TwoTalkersOfAnEpochAreToldApart) {
  const auto at = [](const char* talker, const char* time, const char* latitude) {
    return sentence(std::string(talker) + "GGA," + time + "," + latitude + ",N,11321.30000,E,4,9,1.0,30,M,,M,,");
  };
  const auto text = at("GP", "080150.00", "2308.88200") + at("GN", "080150.00", "2308.88210") +  // 0.2 m
                    at("GN", "080151.00", "2308.88200") + at("GP", "080151.00", "2308.90000") +  // 33 m
                    at("GP", "080152.00", "2308.88200") + at("GP", "080153.00", "2308.88200");
  const auto log = read_nmea(bytes_of(text));
  ASSERT_EQ(log.track.rows(), 4U);
  EXPECT_NEAR(log.track.numbers("latitude_deg")[0], 23 + 8.8821 / 60, 1e-12);
  EXPECT_NEAR(log.track.numbers("latitude_deg")[1], 23 + 8.882 / 60, 1e-12);
  EXPECT_EQ(log.counts.talkers.at("GN"), 2);
  EXPECT_EQ(log.counts.talkers.at("GP"), 4);
  EXPECT_EQ(log.counts.talkers_differ, 1);
  const auto track = read_track(bytes_of(text), "two.nmea", {});
  EXPECT_EQ(track.report.facts.at("talkers"), "GN GP");
  ASSERT_EQ(track.report.findings.size(), 1U);
  EXPECT_EQ(track.report.findings[0].code, "talkers_differ");
}

TEST(Track, TimesThatRunBackAreToldAndRefusedWhereTheyAreMost) {
  std::string csv = "time_s,x_m,y_m\n";
  for (int i = 0; i < 5; ++i) csv += std::to_string(100 + i) + ",1,2\n";
  const auto some = read_track(bytes_of(csv + "50,1,2\n"), "t", {});
  ASSERT_EQ(some.report.findings.size(), 1U);
  EXPECT_EQ(some.report.findings[0].severity, Severity::look);
  for (int i = 0; i < 9; ++i) csv += std::to_string(i) + ",1,2\n";  // the log of an earlier day behind it
  const auto most = read_track(bytes_of(csv), "t", {});
  ASSERT_EQ(most.report.findings.size(), 1U);
  EXPECT_EQ(most.report.findings[0].code, "times_run_back");
  EXPECT_EQ(most.report.findings[0].severity, Severity::refused);
}

struct RealLog {
  const char* name;
  std::int64_t gga, vtg, rmc, bad, without_fix;
};

// Counts of ../shared/data/nmea/nmea_counts.csv.
TEST(Nmea, RealLogsHaveTheirCounts) {
  const std::filesystem::path folder = std::filesystem::path(BOLE_SHARED_DATA_DIR) / "nmea";
  BOLE_NEEDS_REAL(folder);
  for (const RealLog& real :
       {RealLog{"AMOD_AGL3080_20121104_134730.txt", 622, 614, 603, 2, 0},
        RealLog{"TrimbleR2SampleData.txt", 34, 34, 34, 0, 0}, RealLog{"gpsd_hemi.log", 215, 215, 0, 0, 194},
        RealLog{"gpsd_neo-m8n.log", 23, 23, 23, 2, 0}, RealLog{"gpsd_nmea-rtk.log", 122, 0, 122, 0, 0}}) {
    SCOPED_TRACE(real.name);
    const MappedFile file(folder / real.name);
    auto counts = read_nmea(file.bytes()).counts;
    EXPECT_EQ(counts.sentences["GGA"], real.gga);
    EXPECT_EQ(counts.sentences["VTG"], real.vtg);
    EXPECT_EQ(counts.sentences["RMC"], real.rmc);
    EXPECT_EQ(counts.bad_checksum + counts.without_checksum, real.bad);
    EXPECT_EQ(counts.malformed, 0);
    EXPECT_EQ(counts.without_fix, real.without_fix);
  }
  const auto rtk = read_track(folder / "gpsd_nmea-rtk.log", {});
  EXPECT_EQ(rtk.report.counts.at("quality_2"), 104);
  EXPECT_EQ(rtk.report.counts.at("quality_4"), 18);
  EXPECT_GE(rtk.report.counts.at("gaps"), 1);
  TrackOptions fixed;
  fixed.min_quality = 4;
  EXPECT_EQ(read_track(folder / "gpsd_nmea-rtk.log", fixed).table.rows(), 18U);
}

TEST(Track, TheOrchardTrackIsReadInUtm) {
  const auto file = std::filesystem::path(BOLE_SHARED_DATA_DIR) / "orchard_apple_mtls/gnss_track_first_pass.txt";
  BOLE_NEEDS_REAL(file);
  const auto track = read_track(file, {});
  EXPECT_EQ(track.report.facts.at("format"), "columns");
  EXPECT_NEAR(track.table.numbers("x_m")[0], 288334.55, 1e-6);
  EXPECT_NEAR(track.table.numbers("y_m")[0], 4615913.838, 1e-6);
  EXPECT_NEAR(track.table.numbers("time_s")[0], 8 * 3600 + 60 + 50.95, 1e-6);
  EXPECT_GT(track.table.rows(), 3000U);
  EXPECT_LT(track.report.metrics.at("longest_step").value, 5);  // no jumps of 40 at the minutes
}

TEST(Track, AnEmptyQualityIsUnknown) {
  const auto track = read_track(bytes_of("time_s,x_m,y_m,quality\n0,1,2,4\n1,2,2,\n2,3,2,5\n3,4,2,4\n"), "t.csv", {});
  EXPECT_EQ(track.table.rows(), 4U);
  EXPECT_EQ(track.report.counts.at("quality_4"), 2);
  EXPECT_EQ(track.report.counts.at("quality_5"), 1);
  EXPECT_EQ(track.report.counts.at("quality_unknown"), 1);
  try {
    read_track(bytes_of("time_s,x_m,y_m,quality\n0,1,2,good\n"), "t.csv", {});
    FAIL() << "taken";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("t.csv"));
    EXPECT_THAT(e.what(), HasSubstr("quality"));
  }
}

TEST(Track, TablesAndErrors) {
  const std::string csv = "time_s,x_m,y_m\n0,1,2\n1,2,2\n0.5,9,9\n2,3,2\n";
  const auto track = read_track(bytes_of(csv), "t", {});
  EXPECT_EQ(track.table.rows(), 3U);
  EXPECT_EQ(track.report.counts.at("back_in_time"), 1);
  for (const std::string bad : {"", "\n\n", "a,b\n1,2\n", "1 2\n3 4\n"})
    EXPECT_THROW(read_track(bytes_of(bad), "bad", {}), Error);
  try {
    read_track(bytes_of(sentence("GPGGA,080151.00,,,,,0,00,,,M,,M,,")), "empty.nmea", {});
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("empty.nmea"));
    EXPECT_THAT(e.what(), HasSubstr("fix"));
  }
}

}  // namespace
}  // namespace bole::io
