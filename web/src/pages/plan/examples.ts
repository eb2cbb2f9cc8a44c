// Jobs to try: one bench, a server with slots, three benches that share parts, parameters with
// values.
import { emptyBench, emptyJob, partOf, type Job } from './job';

const pumps: Job = {
  ...emptyJob(),
  title: 'Pump bench',
  parts: [
    partOf('Gear pump', 6.5),
    partOf('Vane pump', 7),
    partOf('Relief valve', 2.5),
    partOf('Check valve', 1.5),
    partOf('Filter', 1),
    partOf('Cooler', 4),
    partOf('Motor A', 9),
    partOf('Motor B', 9),
    partOf('Flow meter', 3),
  ],
  atOnce: 4,
  testCost: 12.5,
  changeCost: 3,
};

const server: Job = {
  ...emptyJob(),
  title: 'Server week',
  parts: [
    ...['Xeon 6430', 'Xeon 6448Y', 'Xeon 8462'].map((name) => partOf(name, 14, 'CPU', 1)),
    partOf('DIMM A 32G', 3, 'DIMM', 4),
    partOf('DIMM B 64G', 3, 'DIMM', 2),
    partOf('DIMM C 64G', 3, 'DIMM', 4),
    partOf('E810', 4, 'NIC', 1),
    partOf('X710', 4, 'NIC', 1),
    partOf('CX-6', 5, 'NIC', 1),
    ...['PM9A3', 'P5520', 'CD8'].map((name) => partOf(name, 2, 'SSD', 1)),
    ...['9560', '3908'].map((name) => partOf(name, 6, 'RAID', 1)),
    ...['PSU 800', 'PSU 1600'].map((name) => partOf(name, 8, 'PSU', 1)),
  ],
  atOnce: null,
  testCost: 25,
  unit: 'minutes',
  slots: [
    { name: 'CPU', least: '1', most: '1' },
    { name: 'DIMM', least: '4', most: '4' },
    { name: 'NIC', least: '1', most: '2' },
    { name: 'SSD', least: '1', most: '2' },
    { name: 'RAID', least: '', most: '1' },
    { name: 'PSU', least: '1', most: '1' },
  ],
  never: 'CX-6, PSU 800, 75 W more than it gives\n9560, Xeon 8462, no firmware yet',
};

const benches: Job = {
  ...emptyJob(),
  title: 'Three GPU benches',
  parts: [
    partOf('H100', 0.75, '', 1),
    partOf('A100', 0.75, '', 2),
    partOf('L40S', 0.5, '', 3),
    partOf('Epyc 9654', 1, '', 2),
    partOf('Xeon 8592', 1, '', 3),
    partOf('DDR5-5600', 0.25, '', 3),
    partOf('DDR5-4800', 0.25, '', 3),
    partOf('NVMe A', 0.25, '', 3),
    partOf('NVMe B', 0.25, '', 2),
    partOf('NIC 200G', 0.25, '', 1),
    partOf('NIC 25G', 0.25, '', 3),
    partOf('PSU 2000W', 0.5, '', 3),
  ],
  atOnce: 4,
  testCost: 1.5,
  unit: 'hours',
  benches: [
    { ...emptyBench(), name: 'North', hours: '8', start: 'H100, Epyc 9654' },
    { ...emptyBench(), name: 'South', hours: '8', atOnce: '3', without: 'H100' },
    { ...emptyBench(), name: 'Night', hours: '16' },
  ],
};

const shop: Job = {
  ...emptyJob(),
  title: 'Web shop',
  source: 'model',
  model: `OS:       Debian 12, Fedora 40, Windows 11, macOS 14
Browser:  Firefox, Chrome, Edge, Safari
Database: PostgreSQL, MySQL, SQLite
Locale:   de, en, ja, ar

IF [Browser] = "Safari" THEN [OS] = "macOS 14";
IF [Browser] = "Edge" THEN [OS] IN {"Windows 11", "macOS 14"};
IF [OS] = "macOS 14" THEN [Database] <> "MySQL";
IF [Locale] = "ar" AND [OS] = "Fedora 40" THEN [Database] <> "SQLite";
`,
  testCost: 6,
  unit: 'minutes',
  changeCosts: `parameter, value, cost
OS, 30
OS, Windows 11, 45
OS, macOS 14, 50
Browser, 2
Database, PostgreSQL, 12
Database, MySQL, 10
Database, SQLite, 3
Locale, 1
Locale, ar, 2
OS, Debian 12, Fedora 40, 8
OS, Fedora 40, Debian 12, 8`,
};

type Example = readonly [name: string, job: Job];

export const examples: readonly [Example, ...Example[]] = [
  ['a pump bench', pumps],
  ['a server with slots', server],
  ['three benches', benches],
  ['a web shop (PICT)', shop],
];
