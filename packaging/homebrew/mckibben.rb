# Homebrew formula. The release replaces what stands between @, and adds the file to itself: `checks/release.py recipes`.
class Mckibben < Formula
  desc "Design McKibben pneumatic muscles: from a specification to a muscle"
  homepage "https://github.com/@REPOSITORY@"
  version "@VERSION@"
  license any_of: ["MIT", "Apache-2.0"]

  on_macos do
    on_arm do
      url "https://github.com/@REPOSITORY@/releases/download/v@VERSION@/mckibben-v@VERSION@-aarch64-apple-darwin.tar.gz"
      sha256 "@aarch64-apple-darwin@"
    end
    on_intel do
      url "https://github.com/@REPOSITORY@/releases/download/v@VERSION@/mckibben-v@VERSION@-x86_64-apple-darwin.tar.gz"
      sha256 "@x86_64-apple-darwin@"
    end
  end
  on_linux do
    on_arm do
      url "https://github.com/@REPOSITORY@/releases/download/v@VERSION@/mckibben-v@VERSION@-aarch64-unknown-linux-gnu.tar.gz"
      sha256 "@aarch64-unknown-linux-gnu@"
    end
    on_intel do
      url "https://github.com/@REPOSITORY@/releases/download/v@VERSION@/mckibben-v@VERSION@-x86_64-unknown-linux-gnu.tar.gz"
      sha256 "@x86_64-unknown-linux-gnu@"
    end
  end

  def install
    bin.install "mckibben"
    bash_completion.install "completions/mckibben.bash" => "mckibben"
    zsh_completion.install "completions/mckibben.zsh" => "_mckibben"
    fish_completion.install "completions/mckibben.fish"
    man1.install Dir["man/man1/*"]
  end

  test do
    assert_match "1545.3", shell_output("#{bin}/mckibben force -D 50 -s 1 -p 2.5bar -e 10% --model fe --format json")
  end
end
