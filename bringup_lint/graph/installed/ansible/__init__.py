"""What Ansible's plays and roles name, and whether Ansible finds it."""
