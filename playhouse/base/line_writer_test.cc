#include "playhouse/base/line_writer.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <thread>

namespace playhouse {
namespace {

/// A pipe of one page, which a test reads when it likes.
class Pipe {
 public:
  Pipe() {
    EXPECT_EQ(pipe2(ends_, O_CLOEXEC), 0);
    fcntl(ends_[1], F_SETPIPE_SZ, 4096);
  }
  ~Pipe() {
    close_in();
    close(ends_[0]);
  }
  int in() const { return ends_[1]; }
  void close_in() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }
  /// What is there, up to a page; "" at the end.
  std::string read() {
    std::array<char, 4096> page;
    return {page.data(),
            static_cast<std::size_t>(std::max<ssize_t>(0, ::read(ends_[0], page.data(), page.size())))};
  }
  std::string read_to_end() {
    std::string text;
    for (std::string more; !(more = read()).empty();) text += more;
    return text;
  }

 private:
  int ends_[2];
};

std::string line(int number) {
  return "line " + std::to_string(number) + "\n";
}

TEST(LineWriter, writes_every_line_in_order_before_it_goes) {
  Pipe pipe;
  std::string expected, read;
  std::thread reader([&] { read = pipe.read_to_end(); });
  {
    LineWriter writer(pipe.in());
    for (int i = 0; i < 20000; ++i) {
      writer.add(line(i));
      expected += line(i);
    }
  }
  pipe.close_in();
  reader.join();
  EXPECT_EQ(read, expected);
}

TEST(LineWriter, never_waits_for_a_reader_and_counts_what_does_not_fit_in_its_place) {
  Pipe pipe;
  LineWriter writer(pipe.in());
  const std::string long_line = std::string(4095, 'x') + "\n";
  constexpr int kLines = 3 * LineWriter::kBytes / 4096;
  for (int i = 0; i < kLines; ++i) writer.add(long_line);

  // The writer may have come to the first lines before the last was added: then there is room again, and more
  // than one warning.
  std::string text;
  int kept = 0, lost = 0, warnings = 0;
  while (kept + lost < kLines) {
    text += pipe.read();
    for (std::size_t end; (end = text.find('\n')) != std::string::npos; text.erase(0, end + 1)) {
      int of_these = 0;
      if (text.compare(0, end + 1, long_line) == 0) {
        ++kept;
      } else if (std::sscanf(text.c_str(), "warning: %d lines of the log were lost\n", &of_these) == 1) {
        lost += of_these;
        ++warnings;
      } else {
        FAIL() << text.substr(0, end);
      }
    }
  }
  EXPECT_EQ(kept + lost, kLines);
  EXPECT_GT(warnings, 0);
  EXPECT_GE(static_cast<std::size_t>(kept) * 4096, LineWriter::kBytes);
  writer.add("after\n");
  std::thread reader([&] { text = pipe.read_to_end(); });
  EXPECT_TRUE(writer.flush(std::chrono::minutes(1)));
  pipe.close_in();
  reader.join();
  EXPECT_TRUE(text.ends_with("after\n")) << text.size();
}

TEST(LineWriter, shows_the_newest_status_once_no_line_waits) {
  Pipe pipe;
  {
    LineWriter writer(pipe.in());
    const std::string page(4096, 'x');
    writer.add(page + "\n");  // stalls, and what comes behind it waits
    writer.show("old");
    writer.add("line\n");
    writer.show("new");
    std::thread reader([&] { EXPECT_EQ(pipe.read_to_end(), page + "\nline\nnew"); });
    EXPECT_TRUE(writer.flush(std::chrono::minutes(1)));
    pipe.close_in();
    reader.join();
  }
}

TEST(LineWriter, gives_up_what_cannot_be_written) {
  const int full = open("/dev/full", O_WRONLY | O_CLOEXEC);
  LineWriter writer(full);
  writer.add("line\n");
  EXPECT_TRUE(writer.flush(std::chrono::minutes(1)));
  close(full);
}

}  // namespace
}  // namespace playhouse
