# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin's XML says what the C++ classes do: names, defaults, ranges, enumerations, texts.

    python3 TestXMLDefaults.py PLUGIN_FOLDER
"""

import pathlib
import re
import sys
import unittest
import xml.etree.ElementTree as ElementTree

import evolvingsurfaces as es

PLUGIN = pathlib.Path(sys.argv.pop()) if len(sys.argv) > 1 else pathlib.Path("Plugin")
PROXIES = {
    "DistanceHierarchy": "filters",
    "Icosphere": "sources",
    "LabelSurfaces": "filters",
    "MeshSDF": "filters",
    "ShrinkWrap": "filters",
    "SurfaceEvolution": "filters",
    "TangentialRedistribution": "filters",
}
# Files without a proxy of one of the classes, and what their proxy is.
REPRESENTATIONS = {"HistoryChart": "HistoryChartRepresentation"}
# A range with both ends becomes a slider. Where the upper end is a guard far above any sensible
# value a slider is useless: the XML leaves that end out and the documentation names it.
WITHOUT_SLIDER = {
    ("DistanceHierarchy", "Padding"),
    ("LabelSurfaces", "BackgroundLabel"),
    ("MeshSDF", "Padding"),
    ("ShrinkWrap", "NumberOfSteps"),
    ("SurfaceEvolution", "NumberOfSteps"),
    ("SurfaceEvolution", "OutputInterval"),
    ("SurfaceEvolution", "RemeshingInterval"),
    ("SurfaceEvolution", "SmoothingSteps"),
    ("SurfaceEvolution", "SolverTolerance"),
    ("SurfaceEvolution", "TimeStep"),
    ("TangentialRedistribution", "NumberOfSteps"),
    ("TangentialRedistribution", "TimeStep"),
}
# Guards that are not worth naming.
UNNAMED_GUARDS = {1e12}

LARGEST = {"IntVectorProperty": 2**31 - 1, "DoubleVectorProperty": 1e299}
MOST_VISIBLE = 7


def text(element):
    return re.sub(r"\s+", " ", (element.text or "")).strip() if element is not None else ""


class Proxy:
    """A proxy's XML beside a fresh object of its class."""

    def __init__(self, path):
        self.group = ElementTree.parse(path).getroot().find("ProxyGroup")
        self.xml = self.group.find("SourceProxy")
        self.name = self.xml.get("name")
        self.type = getattr(es, self.xml.get("class"))
        self.inputs = self.xml.findall("InputProperty")
        every = self.xml.findall("IntVectorProperty") + self.xml.findall("DoubleVectorProperty")
        self.information = [p for p in every if p.get("information_only") == "1"]
        self.lists = [p for p in every if p.get("repeat_command") == "1"]
        self.properties = [p for p in every if p not in self.information + self.lists]

    def setters(self):
        inherited = set().union(*(dir(base) for base in self.type.__bases__))
        return {name[3:] for name in dir(self.type)
                if name.startswith("Set") and name not in inherited}

    def value(self, instance, name):
        return getattr(instance, "Get" + name)()

    def clamped(self, element, extreme):
        """What the setter makes of an extreme value in every component."""
        instance = self.type()
        name = element.get("name")
        size = int(element.get("number_of_elements"))
        getattr(instance, "Set" + name)(*([extreme] * size))
        return self.value(instance, name)


PROXY_OF_FILE = {path.stem: Proxy(path) for path in sorted(PLUGIN.glob("*.xml"))
                 if path.stem not in REPRESENTATIONS}


def as_tuple(value):
    return tuple(value) if isinstance(value, (tuple, list)) else (value,)


def numbers(string):
    return None if string is None else tuple(float(word) for word in string.split())


def for_each_property(check):
    """A test that checks every property of every proxy and reports each failure."""
    def test(self):
        for proxy in PROXY_OF_FILE.values():
            for element in proxy.properties:
                with self.subTest(proxy=proxy.name, property=element.get("name")):
                    check(self, proxy, element)
    return test


class XMLTest(unittest.TestCase):
    def test_proxies(self):
        found = {p.name: p.group.get("name") for p in PROXY_OF_FILE.values()}
        self.assertEqual(found, PROXIES)
        listed = re.findall(r"(\w+)\.xml", (PLUGIN / "CMakeLists.txt").read_text())
        self.assertEqual(sorted(listed), sorted([*PROXIES, *REPRESENTATIONS]))

    def test_histories_are_drawn_by_their_representation(self):
        drawn = {}
        for proxy in PROXY_OF_FILE.values():
            for hint in proxy.xml.findall("Hints/Representation"):
                drawn[proxy.name] = (hint.get("view"), hint.get("port"), hint.get("type"))
        file, name = next(iter(REPRESENTATIONS.items()))
        chart = ElementTree.parse(PLUGIN / f"{file}.xml").getroot().find("ProxyGroup")[0]
        self.assertEqual(chart.get("name"), name)
        self.assertEqual(drawn, dict.fromkeys(("ShrinkWrap", "SurfaceEvolution"),
                                              ("XYChartView", "1", name)))

    def test_place_in_the_menu(self):
        for proxy in PROXY_OF_FILE.values():
            with self.subTest(proxy=proxy.name):
                menu = proxy.xml.find("Hints/ShowInMenu")
                self.assertEqual(menu.get("category"), "Evolving Surfaces")
                # Scripts name the constructor after the label.
                self.assertEqual(proxy.xml.get("label").replace(" ", ""), proxy.name)

    @for_each_property
    def test_names_are_the_setters(self, proxy, element):
        self.assertEqual(element.get("command"), "Set" + element.get("name"))
        self.assertTrue(hasattr(proxy.type, element.get("command")))

    def test_lists_are_filled_one_by_one(self):
        for proxy in PROXY_OF_FILE.values():
            for element in proxy.lists:
                with self.subTest(proxy=proxy.name, property=element.get("name")):
                    name = element.get("name")
                    instance = proxy.type()
                    self.assertEqual(getattr(instance, "GetNumberOf" + name)(), 0)
                    getattr(instance, element.get("command"))(3)
                    self.assertEqual(getattr(instance, "GetNumberOf" + name)(), 1)
                    getattr(instance, element.get("clean_command"))()
                    self.assertEqual(getattr(instance, "GetNumberOf" + name)(), 0)

    @for_each_property
    def test_defaults(self, proxy, element):
        default = as_tuple(proxy.value(proxy.type(), element.get("name")))
        self.assertEqual(numbers(element.get("default_values")), default)
        self.assertEqual(int(element.get("number_of_elements")), len(default))

    @for_each_property
    def test_every_property_has_one_domain(self, proxy, element):
        domains = [child.tag for child in element if child.tag.endswith("Domain")]
        self.assertEqual(len(domains), 1, domains)

    @for_each_property
    def test_lower_ends(self, proxy, element):
        domain = element.find("*[@name='range']")
        if domain is not None:
            lowest = -LARGEST[element.tag]
            reached = as_tuple(proxy.clamped(element, lowest))
            expected = None if reached[0] == lowest else reached
            self.assertEqual(numbers(domain.get("min")), expected)

    @for_each_property
    def test_upper_ends(self, proxy, element):
        domain = element.find("*[@name='range']")
        if domain is None:
            return
        largest = LARGEST[element.tag]
        reached = as_tuple(proxy.clamped(element, largest))
        if reached[0] == largest:
            self.assertIsNone(domain.get("max"))
        elif (proxy.name, element.get("name")) in WITHOUT_SLIDER:
            self.assertIsNone(domain.get("max"))
            self.check_named(reached[0], text(element.find("Documentation")))
        else:
            self.assertEqual(numbers(domain.get("max")), reached)

    def check_named(self, guard, documentation):
        if guard not in UNNAMED_GUARDS:
            words = re.findall(r"\d[\d.]*(?:e-?\d+)?", documentation.rstrip("."))
            self.assertIn(guard, [float(word) for word in words], documentation)

    @for_each_property
    def test_booleans(self, proxy, element):
        instance = proxy.type()
        name = element.get("name")
        is_boolean = isinstance(proxy.value(instance, name), bool)
        self.assertEqual(element.find("BooleanDomain") is not None, is_boolean)
        if is_boolean:
            getattr(instance, name + "On")()
            self.assertTrue(proxy.value(instance, name))
            getattr(instance, name + "Off")()
            self.assertFalse(proxy.value(instance, name))

    @for_each_property
    def test_enumerations(self, proxy, element):
        if element.find("EnumerationDomain") is None:
            return
        entries = {int(e.get("value")): e.get("text") for e in element.iter("Entry")}
        first = proxy.clamped(element, -(2**31 - 1))
        last = proxy.clamped(element, 2**31 - 1)
        self.assertEqual(sorted(entries), list(range(first, last + 1)))
        for value, label in entries.items():
            self.check_entry(proxy, element.get("name"), value, label)

    def check_entry(self, proxy, name, value, label):
        constant = label.upper().replace(" ", "_")
        candidates = [constant, constant + "_PRECISION", "WEIGHTING_" + constant,
                      "CONTROL_" + constant]
        values = [getattr(proxy.type, c) for c in candidates if hasattr(proxy.type, c)]
        self.assertIn(value, values, label)
        if name != "OutputPointsPrecision":  # VTK's own enumeration has no setters by name.
            instance = proxy.type()
            getattr(instance, "Set" + name + "To" + label.replace(" ", ""))()
            self.assertEqual(proxy.value(instance, name), value)

    def test_every_setter_is_offered(self):
        for proxy in PROXY_OF_FILE.values():
            with self.subTest(proxy=proxy.name):
                setters = proxy.setters()
                plain = {s for s in setters if "To" not in s or hasattr(proxy.type, "Get" + s)}
                offered = {p.get("name") for p in proxy.properties}
                offered |= {p.get("name") + "Connection" for p in proxy.inputs}
                self.assertEqual(plain - offered, set())

    def test_texts(self):
        for proxy in PROXY_OF_FILE.values():
            documentation = proxy.xml.find("Documentation")
            self.assertGreater(len(documentation.get("short_help")), 20)
            self.assertGreater(len(documentation.get("long_help")), 20)
            self.assertGreater(len(text(documentation)), 100)
            for element in proxy.inputs + proxy.properties + proxy.lists + proxy.information:
                with self.subTest(proxy=proxy.name, property=element.get("name")):
                    self.assertGreater(len(text(element.find("Documentation"))), 20)

    def test_groups_and_decorators_name_properties(self):
        for proxy in PROXY_OF_FILE.values():
            with self.subTest(proxy=proxy.name):
                names = [p.get("name") for p in proxy.properties]
                grouped = [p.get("name") for p in proxy.xml.findall("PropertyGroup/Property")]
                self.assertEqual(len(grouped), len(set(grouped)))
                self.assertLessEqual(set(grouped), set(names))
                if grouped:
                    self.assertEqual(set(names) - set(grouped), set())
                inputs = [p.get("name") for p in proxy.inputs]
                for decorator in proxy.xml.iter("PropertyWidgetDecorator"):
                    self.assertIn(decorator.get("property"), names + inputs)

    def test_a_panel_keeps_the_order_of_its_groups(self):
        # ParaView shows the properties of a group in the order in which they are declared.
        for proxy in PROXY_OF_FILE.values():
            with self.subTest(proxy=proxy.name):
                grouped = [p.get("name") for p in proxy.xml.findall("PropertyGroup/Property")]
                declared = [p.get("name") for p in proxy.xml
                            if p.tag.endswith("VectorProperty") and p.get("name") in grouped]
                self.assertEqual(declared, grouped)

    def test_first_panel_is_short(self):
        for proxy in PROXY_OF_FILE.values():
            defaults = {p.get("name"): p.get("default_values") for p in proxy.properties}
            visible = [p.get("name") for p in proxy.properties + proxy.lists
                       if p.get("panel_visibility") != "advanced" and is_shown(p, defaults)]
            with self.subTest(proxy=proxy.name, visible=visible):
                self.assertLessEqual(len(visible), MOST_VISIBLE)
                self.assertGreaterEqual(len(visible), 2)


def is_shown(element, defaults):
    """Whether the property's decorators show it as long as all values are the defaults."""
    for decorator in element.findall("Hints/PropertyWidgetDecorator[@mode='visibility']"):
        # What is no property is an input, and none at first.
        equal = defaults.get(decorator.get("property"), "null") == decorator.get("value")
        if equal == (decorator.get("inverse") == "1"):
            return False
    return True


if __name__ == "__main__":
    unittest.main()
