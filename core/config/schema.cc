// SPDX-License-Identifier: BSD-3-Clause
#include <string_view>

#include "latchwork/config/agent.h"

namespace latchwork::config {
namespace {

// The documentation of a simple type completes the sentence "'x' is not ...", which is what a
// person reads whose value does not match.
constexpr std::string_view kAgentSchema = R"xsd(<?xml version="1.0" encoding="UTF-8"?>
<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema">
  <xs:element name="agent" type="Agent"/>
  <xs:element name="fragment" type="Fragment"/>

  <xs:complexType name="Agent">
    <xs:choice minOccurs="0" maxOccurs="unbounded">
      <xs:element name="include" type="Include"/>
      <xs:element name="world" type="World"/>
      <xs:element name="layer" type="Layer"/>
      <xs:element name="override" type="Override"/>
      <xs:element name="wire" type="Wire"/>
      <xs:element name="inhibit" type="Inhibit"/>
      <xs:element name="event" type="Event"/>
    </xs:choice>
    <xs:attribute name="format" type="xs:string" use="required"/>
    <xs:attribute name="name" type="Name" use="required"/>
    <xs:attribute name="tick" type="Duration"/>
    <xs:attribute name="duration" type="Duration" use="required"/>
  </xs:complexType>
  <xs:complexType name="Fragment">
    <xs:choice minOccurs="0" maxOccurs="unbounded">
      <xs:element name="include" type="Include"/>
      <xs:element name="world" type="World"/>
      <xs:element name="layer" type="Layer"/>
      <xs:element name="override" type="Override"/>
      <xs:element name="wire" type="Wire"/>
      <xs:element name="inhibit" type="Inhibit"/>
      <xs:element name="event" type="Event"/>
    </xs:choice>
    <xs:attribute name="format" type="xs:string" use="required"/>
  </xs:complexType>

  <xs:complexType name="Include">
    <xs:attribute name="file" type="Path" use="required"/>
  </xs:complexType>
  <xs:complexType name="World">
    <xs:choice minOccurs="0" maxOccurs="unbounded">
      <xs:element name="param" type="Param"/>
    </xs:choice>
    <xs:attribute name="plugin" type="Name" use="required"/>
  </xs:complexType>
  <xs:complexType name="Layer">
    <xs:choice minOccurs="0" maxOccurs="unbounded">
      <xs:element name="param" type="Param"/>
      <xs:element name="reasoner" type="Reasoner"/>
      <xs:element name="minimize" type="Minimize"/>
      <xs:element name="vary" type="Predicate"/>
      <xs:element name="fix" type="Predicate"/>
      <xs:element name="fallback" type="Fallback"/>
    </xs:choice>
    <xs:attribute name="name" type="Name" use="required"/>
    <xs:attribute name="plugin" type="Name" use="required"/>
    <xs:attribute name="period" type="Duration"/>
    <xs:attribute name="phase" type="Duration"/>
    <xs:attribute name="latency" type="Duration"/>
  </xs:complexType>
  <xs:complexType name="Override">
    <xs:choice minOccurs="0" maxOccurs="unbounded">
      <xs:element name="param" type="Param"/>
      <xs:element name="reasoner" type="Reasoner"/>
      <xs:element name="minimize" type="Minimize"/>
      <xs:element name="vary" type="Predicate"/>
      <xs:element name="fix" type="Predicate"/>
      <xs:element name="fallback" type="Fallback"/>
    </xs:choice>
    <xs:attribute name="part" type="Name" use="required"/>
    <xs:attribute name="period" type="Duration"/>
    <xs:attribute name="phase" type="Duration"/>
    <xs:attribute name="latency" type="Duration"/>
  </xs:complexType>

  <xs:complexType name="Param">
    <xs:attribute name="name" type="Name" use="required"/>
    <xs:attribute name="value" type="xs:string" use="required"/>
  </xs:complexType>
  <xs:complexType name="Reasoner">
    <xs:choice minOccurs="0" maxOccurs="unbounded">
      <xs:element name="param" type="Param"/>
    </xs:choice>
    <xs:attribute name="plugin" type="Name"/>
    <xs:attribute name="inferences" type="Inferences"/>
    <xs:attribute name="depth" type="Depth"/>
  </xs:complexType>
  <xs:complexType name="Minimize">
    <xs:attribute name="predicate" type="xs:string" use="required"/>
    <xs:attribute name="depth" type="Depth"/>
    <xs:attribute name="priority" type="Priority"/>
  </xs:complexType>
  <xs:complexType name="Predicate">
    <xs:attribute name="predicate" type="xs:string" use="required"/>
  </xs:complexType>
  <xs:complexType name="Fallback">
    <xs:choice minOccurs="0" maxOccurs="unbounded">
      <xs:element name="fact" type="Fact"/>
    </xs:choice>
  </xs:complexType>
  <xs:complexType name="Fact" mixed="true">
    <xs:attribute name="port" type="Name" use="required"/>
  </xs:complexType>

  <xs:complexType name="Wire">
    <xs:attribute name="from" type="Port" use="required"/>
    <xs:attribute name="to" type="Port" use="required"/>
    <xs:attribute name="stale-after" type="Duration"/>
    <xs:attribute name="transfer" type="Transfer"/>
  </xs:complexType>
  <xs:complexType name="Inhibit">
    <xs:attribute name="by" type="Port" use="required"/>
    <xs:attribute name="output" type="Port" use="required"/>
    <xs:attribute name="hold" type="Duration"/>
  </xs:complexType>
  <xs:complexType name="Event">
    <xs:attribute name="at" type="Duration" use="required"/>
    <xs:attribute name="fact" type="xs:string" use="required"/>
  </xs:complexType>

  <xs:simpleType name="Name">
    <xs:annotation><xs:documentation>a name (a letter, then up to 63 letters, digits, '_' or '-')</xs:documentation></xs:annotation>
    <xs:restriction base="xs:string"><xs:pattern value="[A-Za-z][A-Za-z0-9_\-]{0,63}"/></xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="Port">
    <xs:annotation><xs:documentation>the address of a port: a part, a dot, a port, as in world.sonar</xs:documentation></xs:annotation>
    <xs:restriction base="xs:string"><xs:pattern value="[A-Za-z][A-Za-z0-9_\-]{0,63}\.[A-Za-z][A-Za-z0-9_\-]{0,63}"/></xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="Duration">
    <xs:annotation><xs:documentation>a duration (a number and us, ms, s, min or h, as in 100ms, 1.5s or 2min)</xs:documentation></xs:annotation>
    <xs:restriction base="xs:string"><xs:pattern value="[0-9]{1,9}us|[0-9]{1,9}(\.[0-9]{1,3})?ms|[0-9]{1,9}(\.[0-9]{1,6})?(s|min|h)"/></xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="Transfer">
    <xs:annotation><xs:documentation>what a wire hands down besides proved goals (single: nothing; open: undecided goals; refined: and the states that they may be in together)</xs:documentation></xs:annotation>
    <xs:restriction base="xs:string"><xs:pattern value="single|open|refined"/></xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="Priority">
    <xs:annotation><xs:documentation>a priority (1 to 999; 1 is minimized first)</xs:documentation></xs:annotation>
    <xs:restriction base="xs:string"><xs:pattern value="[1-9][0-9]{0,2}"/></xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="Inferences">
    <xs:annotation><xs:documentation>a number of inferences (a positive integer of up to 18 digits)</xs:documentation></xs:annotation>
    <xs:restriction base="xs:string"><xs:pattern value="[1-9][0-9]{0,17}"/></xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="Depth">
    <xs:annotation><xs:documentation>a depth (a positive integer of up to 9 digits)</xs:documentation></xs:annotation>
    <xs:restriction base="xs:string"><xs:pattern value="[1-9][0-9]{0,8}"/></xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="Path">
    <xs:annotation><xs:documentation>the path of a file</xs:documentation></xs:annotation>
    <xs:restriction base="xs:string"><xs:pattern value=".{1,4096}"/></xs:restriction>
  </xs:simpleType>
</xs:schema>
)xsd";

}  // namespace

std::string_view AgentSchema() { return kAgentSchema; }

}  // namespace latchwork::config
