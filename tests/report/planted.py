"""Secrets as files give them away, and what looks alike and stays readable."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

NAMES = ("password", "DB_PASS", "api_key", "mqtt_token", "client_secret", "wifi_psk", "ACCESS_KEY", "admin_pwd")


class Planted(NamedTuple):
    file: str
    text: str
    secret: str


_EVERY_NAME = (
    ("robot.service", "[Service]\nEnvironment={name}={secret}\nExecStart=/bin/true\n"),
    ("robot.service", "[Service]\nExecStart=/usr/bin/ros2 launch a b.launch.py {name}:={secret}\n"),
    ("robot.service", "[Service]\nExecStart=/usr/bin/ros2 run a b --ros-args -p {name}:={secret}\n"),
    ("robot.service", "[Service]\nExecStart=/usr/bin/bridge --{name} {secret} --port 1\n"),
    ("robot.service", "[Service]\nExecStart=/usr/bin/bridge --{name}={secret}\n"),
    ("Dockerfile", "FROM ros:jazzy\nENV {name} {secret}\n"),
    ("Dockerfile", "FROM ros:jazzy\nARG {name} {secret}\n"),
    ("Dockerfile", "FROM ros:jazzy\nENV {name}={secret}\\ words\n"),
    ("Dockerfile", 'FROM ros:jazzy\nCMD ["ros2", "launch", "a", "b.launch.py", "{name}:={secret}"]\n'),
    ("Dockerfile", 'FROM ros:jazzy\nCMD ["bridge", "--{name}", "{secret}"]\n'),
    ("config/a.yaml", "a:\n  ros__parameters:\n    {name}: {secret}\n"),
    ("config/a.yaml", 'a:\n  ros__parameters: {{{name}: "{secret}"}}\n'),
    ("compose.yaml", "services:\n  a:\n    image: a:1\n    environment:\n      - {name}={secret}\n"),
    ("compose.yaml", "services:\n  a:\n    image: a:1\n    command: ros2 launch a b.launch.py {name}:={secret}\n"),
    ("launch/a.launch.yaml", "launch:\n- let:\n    name: {name}\n    value: {secret}\n"),
    ("launch/a.launch.yaml", "launch:\n- let: {{name: {name}, value: {secret}}}\n"),
    ("launch/a.launch.yaml", "launch:\n- let: {{value: {secret}, name: {name}}}\n"),
    ("launch/a.launch.xml", '<launch>\n<arg name="{name}" default="{secret}"/>\n</launch>\n'),
    ("launch/a.launch.xml", '<launch>\n<let value="{secret}" name="{name}"/>\n</launch>\n'),
    ("launch/a.launch.xml", '<launch>\n<param name="{name}" type="str"\n   value="{secret}"/>\n</launch>\n'),
    ("dds/a.xml", "<dds>\n<property><name>{name}</name><value>{secret}</value></property>\n</dds>\n"),
    ("dds/a.xml", "<dds>\n<property><value>{secret}</value><name>{name}</name></property>\n</dds>\n"),
    ("dds/a.xml", "<dds>\n<{name}>\n  {secret}\n</{name}>\n</dds>\n"),
    ("dds/a.xml", "<dds>\n<{name}><![CDATA[{secret}]]></{name}>\n</dds>\n"),
    ("launch/a.launch.py", 'DeclareLaunchArgument("{name}", default_value="{secret}")\n'),
    ("launch/a.launch.py", 'SetEnvironmentVariable("{name}", "{secret}")\n'),
    ("a/node.py", 'self.declare_parameter("{name}", "{secret}")\n'),
    ("a/node.cpp", 'declare_parameter("{name}", "{secret}");\n'),
    ("a/node.py", '{name} = "{secret}"\n'),
)
_ALONE = (
    (
        "dds/a.xml",
        "<a><PrivateKey>data:,-----BEGIN PRIVATE KEY-----\n{secret}\n-----END PRIVATE KEY-----</PrivateKey></a>",
    ),
    ("a.pem", "-----BEGIN EC PRIVATE KEY-----\n{secret}\n-----END EC PRIVATE KEY-----\n"),
    ("config/a.yaml", "passwords: {{admin: {secret}, guest: x}}\n"),
    ("config/a.yaml", "passwords:\n  admin: {secret}\n"),
    ("config/a.yaml", "pass: {secret}\n"),
    ("etc/NetworkManager/system-connections/modem", "[gsm]\npin=48213967\n"),
    ("etc/netplan/a.yaml", "keys:\n  private: {key}\n"),
    ("a.sh", "curl -u robot:{secret} https://fleet.example.com\n"),
    ("a.sh", 'curl -H "Authorization: Bearer {secret}" https://fleet.example.com\n'),
    ("a.sh", 'curl -H "X-Api-Token: {secret}" https://fleet.example.com\n'),
    ("a.sh", "mysql -u robot -p{secret} fleet\n"),
    ("a.sh", "mysqldump -p{secret} fleet\n"),
    ("a.sh", "sshpass -p {secret} ssh robot@base\n"),
    ("a.sh", "sshpass -p'{secret}' ssh robot@base\n"),
    ("a.sh", "docker login -u robot -p {secret} registry.example.com\n"),
    ("a.sh", "echo {secret} | sudo -S systemctl restart robot\n"),
    ("a.sh", "echo '{secret}' | sudo -k -S true\n"),
    ("a.sh", "sudo -S true <<< {secret}\n"),
    ("a.sh", "echo 'robot:{secret}' | chpasswd\n"),
    ("a.sh", "echo robot:{secret} | sudo chpasswd\n"),
    ("a.sh", "chpasswd <<< 'robot:{secret}'\n"),
    ("a.sh", "echo {secret} | passwd --stdin robot\n"),
    ("a.sh", "useradd -m -p {secret} robot\n"),
    ("a.sh", "wpa_passphrase depot {secret} > wpa.conf\n"),
    ("a.sh", "nmcli dev wifi connect depot password {secret}\n"),
    ("a.sh", "nmcli con modify depot wifi-sec.psk {secret}\n"),
    ("a.sh", "mosquitto_pub -u robot -P {secret} -t a -m b\n"),
    ("a.sh", "redis-cli -a {secret} ping\n"),
    ("compose.yaml", 'services:\n  a:\n    healthcheck: {{test: ["CMD", "redis-cli", "-a", "{secret}", "ping"]}}\n'),
    (
        "compose.yaml",
        "services:\n  a:\n    command:\n      - redis-cli\n      - -a\n      - {secret}\n",
    ),
    ("compose.yaml", 'services:\n  a:\n    command: ["redis-server", "--requirepass", "{secret}"]\n'),
    ("compose.yaml", "services:\n  a:\n    command: [mosquitto_sub, -u, a, -P, {secret}, -t, b]\n"),
    ("compose.yaml", 'services:\n  a:\n    healthcheck: {{test: ["CMD", "mysqladmin", "ping", "-p{secret}"]}}\n'),
    ("compose.yaml", 'services:\n  a:\n    command: ["sshpass", "-p", "{secret}", "ssh", "base"]\n'),
    ("compose.yaml", "services:\n  a:\n    healthcheck: {{test: [CMD, curl, -u, 'a:{secret}', http://a]}}\n"),
    ("compose.yaml", "services:\n  a:\n    command:\n      - --password\n      - {secret}\n"),
    ("group_vars/all.yml", "mqtt:\n  password: |\n    {secret}\n"),
    ("group_vars/all.yml", "- token: >-\n    {secret}\n  note: |\n    a\n"),
    ("a.sh", "bridge --pwd {secret}\n"),
    ("netrc", "machine git.example.com login robot password {secret}\n"),
    ("wpa_supplicant.conf", 'network={{\n  ssid="depot"\n  psk="{secret}"\n}}\n'),
    ("wpa_supplicant.conf", "network={{\n  psk={hex}\n}}\n"),
    ("hostapd.conf", "wpa_passphrase={secret}\n"),
    ("a.env", "REPORT=https://{hex}@reports.example.com/4\n"),
    ("a.env", "CAMERA=rtsp://admin:{secret}@10.0.0.9/front\n"),
    ("a.env", "UPLOAD=https://a.blob.core.windows.net/b?sv=1&sig={secret}\n"),
    ("a.env", "FEED=https://a.example.com/feed?token={secret}\n"),
    ("a.env", "# the key was AKIA{upper}\n"),
    ("a.env", "region:=eu id:=ASIA{upper}\n"),
    ("a.env", "# ghp_{hex}\n"),
    ("a.env", "# github_pat_{hex}\n"),
    ("a.env", "# glpat-{hex}\n"),
    ("a.env", "# xoxb-{hex}\n"),
    ("a.env", "# AIza{key35}\n"),
    ("a.env", "# eyJ{hex}.eyJ{hex}.{hex}\n"),
    ("a.env", "HOOK=https://hooks.slack.com/services/T00000000/B0000/{hex}\n"),
    ("user-data", "#cloud-config\nchpasswd:\n  list: |\n    robot:{secret}\n"),
    ("user-data", "#cloud-config\nusers:\n- name: robot\n  passwd: $6$salt${hex}\n"),
    ("robot.service", "[Service]\nSetCredential=wifi:{secret}\n"),
)


def planted() -> Iterator[Planted]:
    number = 0
    for name in NAMES:
        for file, form in _EVERY_NAME:
            number += 1
            secret = f"zQ{number:03}vKx{number * 7919 % 9973}w"
            yield Planted(file, form.format(name=name, secret=secret), secret)
    for file, form in _ALONE:
        number += 1
        parts = _parts(number)
        secret = next((parts[key] for key in parts if f"{{{key}}}" in form), "48213967")
        yield Planted(file, form.format(**parts), secret)


def _parts(number: int) -> dict[str, str]:
    digits = f"{number * 104729:012}"
    return {
        "secret": f"zQ{number:03}vKx{digits}",
        "key": f"Ab{digits}Cd/efghIjklmnopQrstuvwxyz0123456789A"[:43] + "=",
        "key35": f"Ab{digits}CdefghIjklmnopQrstuvwxyz"[:35],
        "hex": f"{number * 104729:032x}".replace("0000", "0a1b"),
        "upper": f"Q7{digits}ZZ"[:16],
    }


READABLE = (
    "password_file: /etc/robot/password",
    "PASSWORD=${WIFI_PASSWORD}",
    "PASSWORD=$(cat /run/secrets/wifi)",
    "password: {{ wifi_password }}",
    "password: <your password>",
    "password: !vault",
    "password:=$(var password)",
    "-p password:=$PASSWORD",
    "rover ALL=(root) NOPASSWD: /usr/sbin/ip",
    "PasswordAuthentication no",
    "PermitEmptyPasswords no",
    "token_timeout: 30",
    "tokens_per_second: 40",
    "max_tokens: 512",
    "secret: true",
    "secrets:\n  wifi:\n    file: wifi.txt",
    "secrets:\n  - wifi",
    "key: value",
    "keyboard: us",
    "key-management: sae",
    "public_key: ssh-ed25519 AAAAC3NzaC1lZDI1NTE5AAAAIOMqqnkVzrm0SdG6UOoqKLsabgH5C9okWi0dh2l9GKJl robot",
    "ssh-rsa AAAAB3NzaC1yc2EAAAADAQABAAABAQC7 robot@base",
    "image: ros@sha256:2c26b46b68ffc68ff99b453c1d30413413422d706483bfa0f98a5e886266e7ae",
    "PRIVATE_KEY=/etc/robot/key.pem",
    "private-key: /private/key.pem",
    "<PrivateKey>file:/etc/keys/key.pem</PrivateKey>",
    "-----BEGIN CERTIFICATE-----\nMIIB\n-----END CERTIFICATE-----",
    "-----BEGIN PUBLIC KEY-----\nMIIB\n-----END PUBLIC KEY-----",
    "http://10.0.0.9:8080/front",
    "ssh://git@github.com/a/b.git",
    "git+ssh://git@gitlab.example.com/a.git",
    "https://robot@fleet.example.com/a",
    "docker run -u 1000:1000 ros:jazzy",
    "docker run --user 1000:1000 ros:jazzy",
    "curl -fsSL https://example.com/key.asc",
    "curl -o a https://example.com/a.sh",
    "apt-get install -y sshpass libpam-pwquality",
    "apt-get install -y python3-secretstorage",
    "mysql -u robot -p fleet",
    "mysql -P 3306 fleet",
    "test: [CMD, redis-cli, -p, '6379', ping]",
    "command: [mosquitto_sub, -p, '1883', -t, a]",
    "command: [curl, -u, robot, http://a]",
    "- key_of_nothing: a\n  note: |\n    Set the password with passwd",
    "token_note: |\n  read it from the file",
    "- token: $TOKEN\n  note: |\n    what is written here",
    "docker login registry.example.com",
    "docker login --password-stdin registry.example.com",
    "echo $PASSWORD | sudo -S true",
    "echo done | sudo tee /etc/a",
    "cat list | chpasswd",
    "wpa_passphrase depot $PSK",
    "mosquitto_pub -t a -m b -p 1883",
    "gpio_pin: 17",
    "pin: 4",
    "enable_pin=22",
    "spinning: 1200",
    "bypass: on_error",
    "compass: magnetic",
    "compass_topic=imu/mag",
    "PWD=/home/robot",
    "pwd",
    "passthrough: all",
    "passes: 12",
    "Authorization: Bearer $TOKEN",
    "a Bearer token is sent with each request",
    "Bearer authentication",
    "https://a.example.com/?page=2&key=1",
    "monkey=banana",
    "ImportCredential=network.dns",
    "LoadCredential=wifi:/etc/robot/wifi",
    "EnvironmentFile=/etc/robot/secrets.env",
    "ExecStart=/usr/bin/bridge --password-file=/etc/robot/password",
    "ExecStart=/usr/bin/bridge --token-file /etc/robot/token",
    "robot_password:=$(env ROBOT_PASSWORD)",
    '<arg name="password"/>',
    '<param name="token_frame" value="base_link"/>',
    '<arg name="key_frequency" default="20.0"/>',
    "- name: rate\n  value: 20",
    "eyJust_a_name",
    "AKIA is a prefix",
    "password: string",
)
