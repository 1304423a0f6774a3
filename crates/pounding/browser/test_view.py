"""Tests of the page of `pounding view` in Chromium: `cargo xtask check --browser`."""

import base64
import contextlib
import json
import os
import pathlib
import shutil
import statistics
import subprocess
import types

import pytest
from selenium import webdriver
from selenium.webdriver import ActionChains, Keys
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = os.environ.get("POUNDING_PROGRAM", str(ROOT / "target/debug/pounding"))
EL_CENTRO = ROOT / "studies/records/el-centro-1940-ns-chopra.csv"
OTHER = ROOT / "studies/records/el-centro-1940-ns-peer-pacific-engineering.csv"
TOWERS = ROOT / "studies/examples/towers-of-storeys.toml"
PATIENCE = 60


@pytest.fixture(scope="session")
def browser():
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium") or "chromium"
    # Chromium's own walls between processes need more rights than a container gives; the page under test is ours.
    for argument in ["--headless=new", "--no-sandbox", "--window-size=1400,1000", "--disable-dev-shm-usage"]:
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    with webdriver.Chrome(options=options, service=Service(shutil.which("chromedriver"))) as driver:
        yield driver


@contextlib.contextmanager
def served(folder, *arguments):
    """The program while it serves its page, and the address of the page."""
    command = [PROGRAM, "view", "--no-open", *map(str, arguments)]
    with subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as program:
        try:
            yield program, program.stdout.readline().strip()
        finally:
            program.kill()


@pytest.fixture
def demo(tmp_path):
    """A folder with the scene of `pounding demo`."""
    subprocess.run([PROGRAM, "demo"], cwd=tmp_path, check=True, capture_output=True)
    return tmp_path / "pounding-demo"


class Page:
    """A page in its own window."""

    def __init__(self, browser, address):
        self.browser = browser
        self.before = browser.current_window_handle
        browser.switch_to.new_window("tab")
        browser.get(address)
        self.window = browser.current_window_handle

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.browser.switch_to.window(self.window)
        self.browser.close()
        self.browser.switch_to.window(self.before)

    def find(self, name):
        return self.browser.find_element(By.ID, name)

    def text(self, name):
        return self.find(name).text

    def until(self, holds):
        return WebDriverWait(self.browser, PATIENCE, poll_frequency=0.01).until(lambda _: holds())

    def settled(self):
        """Waits until the last run is shown."""
        self.until(lambda: self.browser.execute_script("return document.body.ariaBusy === 'false' && document.body.dataset.runs"))
        return self

    def latency(self):
        """Time from the last move to its picture [ms], once; `None` until it is shown."""
        return self.browser.execute_script(
            "const taken = document.body.dataset.latency; delete document.body.dataset.latency; return taken"
        )

    def fault(self):
        self.until(lambda: self.find("fault").is_displayed())
        return self.text("fault")

    def drop(self, path):
        """Drops a file on the page as a hand does."""
        self.browser.execute_script(
            """const data = new DataTransfer();
            data.items.add(new File([Uint8Array.from(atob(arguments[1]), (one) => one.charCodeAt(0))], arguments[0]));
            document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));""",
            path.name,
            base64.b64encode(path.read_bytes()).decode(),
        )


def summary(folder, scene):
    command = [PROGRAM, "run", scene, "--json"]
    return json.loads(subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True).stdout)


def impulse(found):
    return max(pair["largest"]["impulse_n_s"] for pair in found["pairs"] if pair["largest"])


def drag(page, knob, pixels):
    slider = page.find(f"knob-{knob}")
    page.browser.execute_script("arguments[0].scrollIntoView({block: 'center'})", slider)
    ActionChains(page.browser).click_and_hold(slider).move_by_offset(pixels, 0).release().perform()
    page.settled()


def test_reference_a_dragged_knob_gives_the_numbers_of_run(browser, demo):
    with served(demo, "scene.toml") as (_, address), Page(browser, address) as page:
        page.settled()
        assert "token" not in browser.current_url
        before = page.text("details")
        drag(page, "gap.0", -60)
        assert "gap.0=" in browser.current_url
        page.find("save").click()
        page.until(lambda: "Saved" in page.text("told"))
        turned = summary(demo, "scene-turned-1.json")
        assert turned["scene"]["contacts"][0]["gap_m"] != summary(demo, "scene.toml")["scene"]["contacts"][0]["gap_m"]
        told = page.text("details")
        assert told != before
        floors = turned["structures"]
        numbers = [1e-3 * impulse(turned)]
        numbers += [1e3 * abs(one["peak_displacement_m"]) for one in floors] + [1e-3 * abs(one["peak_shear_force_n"]) for one in floors]
        numbers = [f"{number:.4g}" for number in numbers]
        assert all(number in told for number in numbers), (numbers, told)


def test_reference_the_program_for_python_has_the_turned_scene(browser, demo):
    with served(demo, "scene.toml") as (_, address), Page(browser, address) as page:
        page.settled()
        drag(page, "gap.0", -60)
        browser.execute_cdp_cmd("Browser.grantPermissions", {"permissions": ["clipboardReadWrite", "clipboardSanitizedWrite"]})
        page.find("python").click()
        page.until(lambda: "Copied" in page.text("told"))
        program = browser.execute_async_script("navigator.clipboard.readText().then(arguments[0])")
        page.find("save").click()
        page.until(lambda: "Saved" in page.text("told"))
    scenes = []
    names = types.SimpleNamespace(scene=lambda scene: scenes.append(scene))
    exec(program.replace("import pounding", "").partition("run =")[0], {"pounding": names})
    assert scenes == [json.loads((demo / "scene-turned-1.json").read_text())]


def test_reference_every_guide_opens(browser, tmp_path):
    with served(tmp_path) as (_, address), Page(browser, address) as page:
        page.settled()
        buttons = browser.find_elements(By.CSS_SELECTOR, "#guides button")
        for button in buttons:
            button.click()
            page.settled()
            assert not page.find("fault").is_displayed(), (button.text, page.text("fault"))
            titles = [title.text for title in browser.find_elements(By.CSS_SELECTOR, "#guide h2")]
            assert titles == ([] if button is buttons[0] else [button.text])
        assert [entry for entry in browser.get_log("browser") if entry["level"] == "SEVERE"] == []


def test_limit_two_windows_turn_apart(browser, demo):
    with served(demo, "scene.toml") as (_, address), Page(browser, address) as one:
        one.settled()
        first = one.text("needs")
        with Page(browser, address) as other:
            other.settled()
            drag(other, "gap.0", 80)
            assert other.text("needs") != first
        assert one.text("needs") == first


def test_extreme_a_wrong_token_is_refused(browser, demo):
    with served(demo, "scene.toml") as (_, address), Page(browser, address[:-32] + "0" * 32) as page:
        assert "another token" in page.fault()


def test_extreme_the_page_says_that_the_program_has_ended(browser, demo):
    with served(demo, "scene.toml") as (program, address), Page(browser, address) as page:
        page.settled()
        program.kill()
        program.wait()
        drag(page, "gap.0", 40)
        assert "has ended" in page.fault()


def test_reference_a_dropped_record_shakes_the_scene(browser, demo):
    with served(demo, "scene.toml") as (_, address), Page(browser, address) as page:
        page.settled()
        page.drop(OTHER)
        page.until(lambda: OTHER.name in page.text("shaking"))
        shutil.copy(OTHER, demo / "other.csv")
        (demo / "other.toml").write_text((demo / "scene.toml").read_text().replace("el-centro.csv", "other.csv"))
        assert f"{1e-3 * impulse(summary(demo, 'other.toml')):.4g}" in page.text("details")
        # Nothing is written, neither now nor by `Save scene`, which has no name of the file.
        before = sorted(demo.rglob("*"))
        page.find("save").click()
        assert "in no folder" in page.fault()
        assert sorted(demo.rglob("*")) == before
        page.find("reset").click()
        page.until(lambda: "el-centro.csv" in page.text("shaking"))


def test_extreme_a_wrong_file_is_refused_in_the_words_of_the_reader(browser, demo):
    with served(demo, "scene.toml") as (_, address), Page(browser, address) as page:
        page.settled()
        wrong = demo / "wrong.csv"
        wrong.write_text("a letter to a friend\nwho has no accelerometer\n")
        page.drop(wrong)
        assert "wrong.csv" in page.fault()
        large = demo / "large.csv"
        large.write_bytes(b"0\n" * (5 << 20))
        page.find("file").send_keys(str(large))
        page.until(lambda: "MB" in page.text("fault"))
        # The page goes on.
        drag(page, "gap.0", 40)
        assert not page.find("fault").is_displayed()


def test_reference_a_range_of_a_history_is_picked_by_dragging(browser, demo):
    with served(demo, "scene.toml") as (_, address), Page(browser, address) as page:
        page.settled()
        page.find("play").click()
        canvas = browser.find_element(By.CSS_SELECTOR, ".canvas")
        ActionChains(browser).move_to_element_with_offset(canvas, -100, 0).click_and_hold().move_by_offset(150, 0).release().perform()
        page.until(lambda: page.find("whole").is_displayed())
        span = [float(page.find("time").get_attribute(end)) for end in ("min", "max")]
        assert 0 < span[0] < span[1] < 31, span
        page.find("whole").click()
        assert float(page.find("time").get_attribute("min")) == 0


@pytest.mark.parametrize("scene", [None, TOWERS], ids=["two", "towers"])
def test_limit_time_from_a_move_to_its_picture(browser, tmp_path, capsys, scene):
    with served(tmp_path, *filter(None, [scene])) as (_, address), Page(browser, address) as page:
        page.settled()
        page.find("play").click()
        # Turning a gap takes the widths that gaps need from the run before; a period asks for new ones.
        for knob in ["gap.0", "period.0"]:
            slider = page.find(f"knob-{knob}")
            taken = []
            for _ in range(21):
                slider.send_keys(Keys.ARROW_RIGHT)
                page.settled()
                taken.append(float(page.until(page.latency)))
            with capsys.disabled():
                name = "two structures" if scene is None else scene.name
                middle = f"{statistics.median(taken):.0f} ms (median of {len(taken)}, load {os.getloadavg()[0]:.1f})"
                print(f"\n{name}: from a move of {knob} to its picture {middle}")
